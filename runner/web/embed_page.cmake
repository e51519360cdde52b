# Embeds the page in the program: embedded_page.cpp holds the text of each file. On the server all of them are in one
# folder: /page/uPlot.js.
set(page_files
  axis_choice.js
  axis_scale.js
  boundary.js
  brush.js
  capsule_scene.js
  capsule_view.js
  capsules.js
  case_details.js
  case_list.js
  case_study.js
  colour_map.js
  curves.js
  diagram.js
  download.js
  elements.js
  icon.svg
  index.html
  link.js
  marks.js
  open_cases.js
  page.css
  page.js
  path_of_q.js
  point_dialog.js
  progress_line.js
  save_picture.js
  server.js
  shapes.js
  study_actions.js
  study_list.js
  study_view.js
  submit_form.js
  tensors.js
  time_left.js
  time_slider.js
  token_dialog.js
  verdict.js
  vertex_fields.js
  words.js
  vendor/three.LICENSE.txt
  vendor/three.module.min.js
  vendor/uPlot.LICENSE.txt
  vendor/uPlot.css
  vendor/uPlot.js)

set(type_of_.html "text/html; charset=utf-8")
set(type_of_.css "text/css; charset=utf-8")
set(type_of_.js "text/javascript; charset=utf-8")
set(type_of_.svg "image/svg+xml")
set(type_of_.txt "text/plain; charset=utf-8")

set(CAPSTAN_PAGE_FILES "")
foreach(file IN LISTS page_files)
  cmake_path(GET file FILENAME name)
  cmake_path(GET file EXTENSION LAST_ONLY extension)
  set(path /page/${name})
  if(name STREQUAL index.html)
    set(path /)
  endif()
  file(READ ${CMAKE_CURRENT_SOURCE_DIR}/web/page/${file} text)
  string(APPEND CAPSTAN_PAGE_FILES "    {\"${path}\", \"${type_of_${extension}}\", R\"page(${text})page\"sv},\n")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/web/page/${file})
endforeach()
configure_file(web/embedded_page.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/embedded_page.cpp @ONLY)

# A file is one string literal, however long it is. The standard lets a compiler refuse literals above 65536
# characters, of which clang's -Wpedantic warns; g++ and clang take any length.
set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/embedded_page.cpp PROPERTIES
  COMPILE_OPTIONS -Wno-overlength-strings)
