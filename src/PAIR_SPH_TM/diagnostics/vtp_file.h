/* SPH-TM: a VTK XML file of points or of triangles (.vtp), with its numbers as raw binary data behind the XML. All sizes
   are given before the first number, so that values may come in pieces and in any order: nothing is kept. */
#ifndef SPHTM_VTP_FILE_H
#define SPHTM_VTP_FILE_H

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace SPHTM_NS {

class VtpFile {
 public:
  enum Type { INT32, INT64, FLOAT32, FLOAT64 };
  enum Place { POINT_DATA, CELL_DATA, POINTS, CELLS };    // in the order of the file
  struct Array {
    Place place;
    std::string name;
    Type type;
    int components;
  };
  // cells: 0 for a point each
  VtpFile(FILE *f, int64_t n_points, int64_t n_triangles) : file(f), points(n_points), triangles(n_triangles) {}

  // begin() adds the cells of points; those of triangles are array triangle_corners()
  void begin(const std::vector<Array> &, double time);
  // rows first to first + count of an array: of each row of values these columns; -1 stands for 0
  void put(size_t array, int64_t first, int64_t count, const double *rows, int row_length,
           const std::vector<int> &columns);
  size_t triangle_corners() const { return corners; }
  void end();

 private:
  struct Block {
    Array array;
    int64_t tuples, at;    // place of its first number behind that of the data
  };
  FILE *file;
  int64_t points, triangles;
  int64_t data = 0, size = 0;    // where the data begin, how many bytes
  size_t corners = 0;
  std::vector<Block> blocks;
  std::vector<char> room;

  void add(const Array &, int64_t tuples);
  void write_xml(double time) const;
  void put_sequence(size_t array, int64_t begin, int64_t step);
  void put_bytes(const Block &, int64_t first_value, int64_t values);
};

// text for an attribute of XML
std::string xml_text(const std::string &);

}    // namespace SPHTM_NS

#endif
