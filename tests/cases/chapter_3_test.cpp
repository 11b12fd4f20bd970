// What `delabole reproduce chapter3` says, and the groundwater of chapter 2.
#include "reproduction_fixture.hpp"

namespace delabole {
namespace {

class Chapter3 : public testing::ReproductionTest {
  protected:
    Chapter3() : ReproductionTest(chapter_3()) {}
};

}  // namespace
}  // namespace delabole
