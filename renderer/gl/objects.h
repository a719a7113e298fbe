// SPDX-License-Identifier: MIT
// Move-only owners of GL objects. An owner that was moved from, or never given anything, is empty:
// id 0. Nothing here binds on destruction.
#pragma once

#include <glad/gl.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace romascope {

/// The id of one GL object and the function that deletes it.
template <void (*Delete)(GLuint)>
class GlHandle {
public:
    GlHandle() = default;
    explicit GlHandle(GLuint id) : id_(id) {}
    ~GlHandle() {
        if (id_)
            Delete(id_);
    }
    GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    GLuint id() const { return id_; }

private:
    GLuint id_ = 0;
};

void delete_buffer(GLuint id);
void delete_texture(GLuint id);
void delete_framebuffer(GLuint id);
void delete_vertex_array(GLuint id);
void delete_program(GLuint id);
void delete_query(GLuint id);

/// Memory on the GPU of fixed size. Throws Error if the driver has none left.
class Buffer {
public:
    Buffer() = default;
    /// Zeroed.
    Buffer(const std::string& label, size_t bytes);
    template <class T>
    static Buffer from(const std::string& label, std::span<const T> data) {
        return Buffer(label, std::as_bytes(data));
    }
    Buffer(const std::string& label, std::span<const std::byte> data);

    GLuint id() const { return handle_.id(); }
    size_t bytes() const { return bytes_; }
    /// Whole words. Commands before it see what was there, those after it what is new.
    void upload(std::span<const std::byte> data, size_t offset = 0);
    template <class T>
    std::vector<T> download() const {
        std::vector<T> data(bytes_ / sizeof(T));
        download_bytes(std::as_writable_bytes(std::span(data)));
        return data;
    }
    void bind(GLenum target, GLuint slot) const; ///< uniform or shader storage block
    /// Binds what lies from `offset` on to a shader storage block, or from a little before, where
    /// the driver wants it to begin. Returns the offset it begins at, a multiple of 4.
    size_t bind_storage_from(GLuint slot, size_t offset) const;

private:
    void create(const std::string& label, size_t bytes, const void* data);
    void download_bytes(std::span<std::byte> data) const;
    GlHandle<delete_buffer> handle_;
    size_t bytes_ = 0;
};

/// A 2D, 2D array or 3D texture with one level, nearest filtering, clamped to the edge.
/// Throws Error if the driver cannot hold it.
class Texture {
public:
    Texture() = default;
    /// `size.z`: layers of an array or depth; 1 with GL_TEXTURE_2D.
    Texture(const std::string& label, GLenum target, GLenum format, glm::ivec3 size);

    GLuint id() const { return handle_.id(); }
    GLenum target() const { return target_; }
    GLenum format() const { return format_; }
    glm::ivec3 size() const { return size_; }
    size_t bytes() const;
    void bind(GLuint unit) const;
    /// All layers at once where there are several.
    void bind_image(GLuint unit, GLenum access) const;
    void clear_uint(GLuint value);
    /// All texels, `components` values each, x fastest, then y, then z.
    std::vector<float> download_float(int components) const;
    std::vector<GLuint> download_uint(int components) const;

private:
    GlHandle<delete_texture> handle_;
    GLenum target_ = 0;
    GLenum format_ = 0;
    glm::ivec3 size_{0};
};

/// The texels of a buffer that belongs to someone else and lives longer. A driver fetches the first
/// GL_MAX_TEXTURE_BUFFER_SIZE of them.
class TexelView {
public:
    TexelView() = default;
    TexelView(const std::string& label, GLenum format, const Buffer& buffer);
    GLuint id() const { return handle_.id(); }
    void bind(GLuint unit) const;

private:
    GlHandle<delete_texture> handle_;
};

/// A row of texels in a buffer, fetched as a texture and written as an image, each texel by its
/// place alone. Throws Error if the driver cannot hold it.
class TexelBuffer {
public:
    TexelBuffer() = default;
    /// Zeroed.
    TexelBuffer(const std::string& label, GLenum format, size_t texels);

    GLenum format() const { return format_; }
    size_t texels() const { return texels_; }
    size_t bytes() const { return buffer_.bytes(); }
    void bind(GLuint unit) const { view_.bind(unit); }
    void bind_image(GLuint unit, GLenum access) const;
    void bind_storage(GLuint slot) const { buffer_.bind(GL_SHADER_STORAGE_BUFFER, slot); }
    /// All texels, the components of each after one another.
    std::vector<GLuint> download() const { return buffer_.download<GLuint>(); }

private:
    Buffer buffer_;
    TexelView view_;
    GLenum format_ = 0;
    size_t texels_ = 0;
};

/// A framebuffer of textures, or of a size alone for passes that write by image stores only.
class Framebuffer {
public:
    Framebuffer() = default;
    Framebuffer(const std::string& label, std::span<const Texture* const> colors,
                const Texture* depth);
    Framebuffer(const std::string& label, glm::ivec2 size);

    GLuint id() const { return handle_.id(); }
    /// Makes it the target of draws, with a viewport over all of it.
    void bind() const;

private:
    GlHandle<delete_framebuffer> handle_;
    glm::ivec2 size_{0};
};

} // namespace romascope
