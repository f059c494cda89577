# Writes `source`, which defines what `header` declares, from the text in `files`.
set(text "#include \"${header}\"\n\nnamespace clast::${folder}_detail::assets {\n\n")
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  string(MAKE_C_IDENTIFIER ${name} name)
  file(READ ${file} asset)
  string(APPEND text "const std::string_view ${name} = R\"asset(${asset})asset\";\n\n")
endforeach()
file(WRITE ${source} "${text}}  // namespace clast::${folder}_detail::assets\n")
