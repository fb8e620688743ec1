// Benchmark of the forms for one mesh: bytes per face, build time per pairing method, time per query. All figures are
// measured at run time.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ryosen/base/stopwatch.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/form.h"
#include "ryosen/textbook/forms/pairing.h"
#include "ryosen/textbook/forms/source_operators.h"

namespace ryosen::forms {

struct Effort {
  double query_seconds = 0.005;  // per form and relation; at least one query is made
  double pairing_steps = 1e8;    // a method that needs more is measured on the first faces only
};

struct FormFigures {
  const FormRow* row = nullptr;
  std::optional<Text> unsuitable;  // set: the rest is empty
  std::size_t bytes = 0;
  double build_seconds = 0;  // from the mesh
  // Mean over random elements in the fastest round, by relation; empty if the form cannot answer it or there are no
  // elements.
  std::array<std::optional<double>, relation_count> query_seconds;
};

struct PairingFigures {
  const PairingMethod* method = nullptr;
  std::size_t faces = 0, all_faces = 0;  // the faces that were paired, the first ones, and all faces
  double steps_of_all = 1;               // steps for all faces divided by the steps measured
  double seconds = 0;                    // the fastest of up to three runs

  bool is_whole() const { return faces == all_faces; }
};

struct Comparison {
  std::uint32_t vertices = 0, edges = 0, faces = 0;  // points and point pairs
  std::vector<FormFigures> forms;
  std::vector<PairingFigures> pairing;
  std::vector<SourceReport> texts;
};

// Cost: about the effort per form and relation, plus building each form once.
Comparison compare_forms(const Mesh& mesh, const Effort& effort = {});

// The claim of text 002, section 2.3, about the memory of two of its own forms.
struct SizeClaim {
  std::string_view smaller, larger;  // ids of forms
  std::string_view en, ja;           // the claim
  std::string_view why_en, why_ja;   // what decides, as the forms are stored here
};
struct ComparedClaim {
  const SizeClaim* claim;
  bool holds;
  Text sentence;  // the claim, whether it holds here, and the bytes per face of both
};
// The claims about forms that both hold the mesh; none without faces.
std::vector<ComparedClaim> compare_claims(const Comparison& comparison);

// The seconds of the fastest of several runs, fewer where they have taken enough; freeing what is made does not count.
template <class Work>
double fastest_of(int runs, double enough_seconds, Work work) {
  double best = std::numeric_limits<double>::infinity(), spent = 0;
  for (int run = 0; run < runs && spent < enough_seconds; ++run) {
    const Stopwatch watch;
    [[maybe_unused]] const auto made = work();
    const double taken = watch.seconds();
    best = std::min(best, taken);
    spent += taken;
  }
  return best;
}

// One method.
PairingFigures measure_pairing(const IndexedMesh& source, const PairingMethod& method, const Effort& effort);

// Three significant digits, or whole numbers from 100 on; with a unit from ns to ms.
std::string figure_text(double value);
std::string duration_text(double seconds);

// How many of the first faces a method can pair within `steps` steps.
std::size_t faces_within(const IndexedMesh& source, const PairingMethod& method, double steps);

// Elements to ask the forms of a mesh about, the same for every form: up to 256 random vertices, edges by their ends,
// and faces, in the numbers of the forms. The same for the same mesh.
struct Questions {
  explicit Questions(const Mesh& mesh);

  std::vector<std::uint32_t> vertices, faces;
  std::vector<EdgeEnds> edges;
};

// A form's handles of these edges, as many as can be found within the time, but at least one where there is one.
std::vector<std::uint32_t> handles_of(const Form& form, const std::vector<EdgeEnds>& edges, double seconds);

// Seconds per query, of the fastest of several rounds; each takes at least an eighth of `seconds`. None where the form
// cannot answer, or nothing is asked.
std::optional<double> time_per_query(const Form& form, Relation relation, const std::vector<std::uint32_t>& elements,
                                     double seconds);

}  // namespace ryosen::forms
