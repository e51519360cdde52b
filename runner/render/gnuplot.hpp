#pragma once
// Pictures by gnuplot: the parts of a script that all pictures share, and the run of a script.
#include <filesystem>
#include <string>

namespace capstan {

enum class PictureWidth { one_column, two_columns };  ///< of a journal's page: 8.5 and 17.5 cm

struct PictureFormat {
  std::filesystem::path file;  ///< ends in .svg, .pdf or .png
  PictureWidth width = PictureWidth::one_column;
};

/// The reason why the file cannot be a picture; "" if it can.
std::string issue_of_picture_file(const std::filesystem::path& file);

/// The first lines of a script: the terminal and the file, fonts, line widths.
/// \param height  over width
std::string picture_head(const PictureFormat& format, double height);

/// A text in gnuplot's quotes, without its markup.
std::string quoted_text(const std::string& text);

/// "θ/π", "D_xy" with its index: the name of a quantity or parameter, with gnuplot's markup, in quotes.
std::string symbol(const std::string& name);

/// Writes the script beside the picture (FILE.gp) and runs it there. Throws std::runtime_error if gnuplot
/// cannot be started or reports an error.
void draw(const std::string& script, const PictureFormat& format);

}  // namespace capstan
