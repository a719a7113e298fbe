# cmake -DROOT=folder "-DFILES=a;b" -DOUT=file.cpp -DNAME=function -P EmbedText.cmake
# Writes a C++ file with a function NAME() that gives the texts of FILES by their path below ROOT.
set(body "")
foreach(file IN LISTS FILES)
  file(READ ${ROOT}/${file} text)
  # A compiler need not take string literals beyond 64 KiB; adjacent ones are joined.
  string(REGEX REPLACE "(\n[^\n]*){200}" "\\0)~~\" R\"~~(" text "${text}")
  string(APPEND body "    {\"${file}\", R\"~~(${text})~~\"},\n")
endforeach()
file(WRITE ${OUT} "#include \"renderer/base/embedded_text.h\"
namespace romascope {
const EmbeddedTexts& ${NAME}() {
    static const EmbeddedTexts texts = {
${body}    };
    return texts;
}
} // namespace romascope
")
