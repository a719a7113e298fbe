// SPDX-License-Identifier: MIT
#include "renderer/gl/objects.h"

#include "renderer/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace romascope {
namespace {

/// Storage is asked for with the error queue empty, so that a failure is this object's own.
void clear_errors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

void require_storage(const std::string& label, size_t bytes) {
    const GLenum code = glGetError();
    if (code == GL_NO_ERROR)
        return;
    throw Error(fmt::format("the driver has no room for '{}' ({:.1f} MiB): choose a smaller size",
                            label, static_cast<double>(bytes) / (1 << 20)));
}

void set_label(GLenum kind, GLuint id, const std::string& label) {
    glObjectLabel(kind, id, static_cast<GLsizei>(label.size()), label.data());
}

size_t bytes_per_texel(GLenum format) {
    switch (format) {
    case GL_R16:
        return 2;
    case GL_R32UI:
    case GL_R32F:
    case GL_RGBA8:
    case GL_SRGB8_ALPHA8:
    case GL_R11F_G11F_B10F:
    case GL_DEPTH_COMPONENT32F:
        return 4;
    case GL_RG32UI:
        return 8;
    case GL_RGBA32UI:
    case GL_RGBA32F:
        return 16;
    default:
        assert(!"add the format here");
        return 0;
    }
}

} // namespace

void delete_buffer(GLuint id) { glDeleteBuffers(1, &id); }
void delete_texture(GLuint id) { glDeleteTextures(1, &id); }
void delete_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
void delete_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
void delete_program(GLuint id) { glDeleteProgram(id); }
void delete_query(GLuint id) { glDeleteQueries(1, &id); }

Buffer::Buffer(const std::string& label, size_t bytes) {
    create(label, bytes, nullptr);
    glClearNamedBufferData(id(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
}

Buffer::Buffer(const std::string& label, std::span<const std::byte> data) {
    create(label, data.size(), data.empty() ? nullptr : data.data());
}

void Buffer::create(const std::string& label, size_t bytes, const void* data) {
    GLuint id = 0;
    glCreateBuffers(1, &id);
    handle_ = GlHandle<delete_buffer>(id);
    bytes_ = bytes;
    set_label(GL_BUFFER, id, label);
    clear_errors();
    // GL knows no empty buffers.
    glNamedBufferStorage(id, static_cast<GLsizeiptr>(std::max<size_t>(bytes, 4)),
                         bytes >= 4 ? data : nullptr, GL_DYNAMIC_STORAGE_BIT);
    require_storage(label, bytes);
}

void Buffer::upload(std::span<const std::byte> data, size_t offset) {
    assert(offset + data.size() <= bytes_ && data.size() % 4 == 0);
    if (data.empty())
        return;
    // Not by glNamedBufferSubData: while a buffer is new, NVIDIA's driver (580.159) lets that
    // overtake commands before it that read the buffer or clear it. A copy stays in line.
    const Buffer staging("upload", data);
    glCopyNamedBufferSubData(staging.id(), id(), 0, static_cast<GLintptr>(offset),
                             static_cast<GLsizeiptr>(data.size()));
}

void Buffer::download_bytes(std::span<std::byte> data) const {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(id(), 0, static_cast<GLsizeiptr>(data.size()), data.data());
}

void Buffer::bind(GLenum target, GLuint slot) const { glBindBufferBase(target, slot, id()); }

size_t Buffer::bind_storage_from(GLuint slot, size_t offset) const {
    assert(offset < bytes_);
    GLint alignment = 1;
    glGetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const size_t start = offset - offset % static_cast<size_t>(std::max(alignment, 4));
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, slot, id(), static_cast<GLintptr>(start),
                      static_cast<GLsizeiptr>(bytes_ - start));
    return start;
}

Texture::Texture(const std::string& label, GLenum target, GLenum format, glm::ivec3 size)
    : target_(target), format_(format), size_(size) {
    GLuint id = 0;
    glCreateTextures(target, 1, &id);
    handle_ = GlHandle<delete_texture>(id);
    set_label(GL_TEXTURE, id, label);
    clear_errors();
    if (target == GL_TEXTURE_2D)
        glTextureStorage2D(id, 1, format, size.x, size.y);
    else
        glTextureStorage3D(id, 1, format, size.x, size.y, size.z);
    require_storage(label, bytes());
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTextureParameteri(id, wrap, GL_CLAMP_TO_EDGE);
}

size_t Texture::bytes() const {
    if (id() == 0)
        return 0; // and has no format
    return static_cast<size_t>(size_.x) * static_cast<size_t>(size_.y) *
           static_cast<size_t>(size_.z) * bytes_per_texel(format_);
}

void Texture::bind(GLuint unit) const { glBindTextureUnit(unit, id()); }

void Texture::bind_image(GLuint unit, GLenum access) const {
    const GLboolean layered = target_ == GL_TEXTURE_2D ? GL_FALSE : GL_TRUE;
    glBindImageTexture(unit, id(), 0, layered, 0, access, format_);
}

void Texture::clear_uint(GLuint value) {
    const GLuint texel[4] = {value, value, value, value};
    const GLenum layout = format_ == GL_R32UI    ? GL_RED_INTEGER
                          : format_ == GL_RG32UI ? GL_RG_INTEGER
                                                 : GL_RGBA_INTEGER;
    glClearTexImage(id(), 0, layout, GL_UNSIGNED_INT, texel);
}

std::vector<float> Texture::download_float(int components) const {
    const GLenum layouts[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    const GLenum layout =
        format_ == GL_DEPTH_COMPONENT32F ? GLenum{GL_DEPTH_COMPONENT} : layouts[components - 1];
    std::vector<float> data(static_cast<size_t>(size_.x) * size_.y * size_.z * components);
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(id(), 0, layout, GL_FLOAT, static_cast<GLsizei>(data.size() * 4),
                      data.data());
    return data;
}

std::vector<GLuint> Texture::download_uint(int components) const {
    const GLenum layouts[] = {GL_RED_INTEGER, GL_RG_INTEGER, GL_RGB_INTEGER, GL_RGBA_INTEGER};
    std::vector<GLuint> data(static_cast<size_t>(size_.x) * size_.y * size_.z * components);
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(id(), 0, layouts[components - 1], GL_UNSIGNED_INT,
                      static_cast<GLsizei>(data.size() * 4), data.data());
    return data;
}

TexelBuffer::TexelBuffer(const std::string& label, GLenum format, size_t texels)
    : format_(format), texels_(texels) {
    const size_t bytes = texels * bytes_per_texel(format);
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (texels > static_cast<size_t>(most))
        throw Error(fmt::format("the driver has no room for '{}' ({:.1f} MiB, it takes {} texels): "
                                "choose a smaller size",
                                label, static_cast<double>(bytes) / (1 << 20), most));
    buffer_ = Buffer(label, bytes);
    view_ = TexelView(label, format, buffer_);
}

void TexelBuffer::bind_image(GLuint unit, GLenum access) const {
    glBindImageTexture(unit, view_.id(), 0, GL_FALSE, 0, access, format_);
}

TexelView::TexelView(const std::string& label, GLenum format, const Buffer& buffer) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &id);
    handle_ = GlHandle<delete_texture>(id);
    set_label(GL_TEXTURE, id, label);
    glTextureBuffer(id, format, buffer.id());
}

void TexelView::bind(GLuint unit) const { glBindTextureUnit(unit, handle_.id()); }

Framebuffer::Framebuffer(const std::string& label, std::span<const Texture* const> colors,
                         const Texture* depth) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    handle_ = GlHandle<delete_framebuffer>(id);
    set_label(GL_FRAMEBUFFER, id, label);
    std::vector<GLenum> buffers;
    for (const Texture* color : colors) {
        const auto slot = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + buffers.size());
        glNamedFramebufferTexture(id, slot, color->id(), 0);
        buffers.push_back(slot);
        size_ = color->size();
    }
    glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(buffers.size()), buffers.data());
    if (depth) {
        glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, depth->id(), 0);
        size_ = depth->size();
    }
    if (glCheckNamedFramebufferStatus(id, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(fmt::format("the driver does not accept the framebuffer '{}'", label));
}

Framebuffer::Framebuffer(const std::string& label, glm::ivec2 size) : size_(size) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    handle_ = GlHandle<delete_framebuffer>(id);
    set_label(GL_FRAMEBUFFER, id, label);
    glNamedFramebufferParameteri(id, GL_FRAMEBUFFER_DEFAULT_WIDTH, size.x);
    glNamedFramebufferParameteri(id, GL_FRAMEBUFFER_DEFAULT_HEIGHT, size.y);
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, id());
    glViewport(0, 0, size_.x, size_.y);
}

} // namespace romascope
