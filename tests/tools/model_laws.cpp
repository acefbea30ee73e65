#include "tools/model_laws.h"

namespace airlight::test {

std::vector<PointLaw> model_laws() {
    std::vector<PointLaw> laws;
    for (const auto& family : {
             analytic_model_laws(),
             table_model_laws(),
             marched_model_laws(),
         })
        laws.insert(laws.end(), family.begin(), family.end());
    return laws;
}

}  // namespace airlight::test
