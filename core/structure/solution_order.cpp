#include "core/structure/solution_order.hpp"

#include "core/structure/index_reduction.hpp"
#include "core/structure/matching.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {

Outcome<std::vector<SolutionBlock>> orderSolution(EquationSystem& system, const std::vector<Equation>& equations,
                                                  const std::vector<char>& isKnown) {
    LeafCollector collect(*system.pool);
    Adjacency incidence(equations.size());
    for (std::size_t e = 0; e < equations.size(); ++e) {
        const ExpressionId sides[] = {equations[e].left, equations[e].right};
        for (const ExpressionId leaf : collect.leaves(sides))
            if (const int u = system.unknownOf(leaf); u >= 0 && !isKnown[static_cast<std::size_t>(u)])
                incidence[e].push_back(u);
    }
    const int columns = static_cast<int>(system.unknowns.size());
    Matching matching(incidence, columns);
    const bool isMatched = matching.augmentAll();
    std::vector<int> surplus, undetermined;
    for (int e = 0; !isMatched && e < static_cast<int>(equations.size()) && surplus.empty(); ++e)
        if (matching.columnOf(e) < 0 && !matching.augment(e)) surplus = matching.visitedRows();
    for (int u = 0; u < columns; ++u)
        if (!isKnown[static_cast<std::size_t>(u)] && matching.rowOf(u) < 0) undetermined.push_back(u);
    if (!surplus.empty() || !undetermined.empty()) return singularSystem(system, equations, surplus, undetermined, {});

    Adjacency dependsOn(equations.size());
    for (std::size_t e = 0; e < equations.size(); ++e)
        for (const int u : incidence[e])
            if (matching.rowOf(u) != static_cast<int>(e)) dependsOn[e].push_back(matching.rowOf(u));
    std::vector<SolutionBlock> blocks;
    DependenceCheck depends(*system.pool);
    for (const std::vector<int>& component : strongComponents(dependsOn)) {
        std::vector<Equation> members;
        std::vector<ExpressionId> unknowns;
        for (const int e : component) {
            members.push_back(equations[static_cast<std::size_t>(e)]);
            unknowns.push_back(system.unknowns[static_cast<std::size_t>(matching.columnOf(e))].node);
        }
        Outcome<std::vector<SolutionBlock>> solved = solveComponent(system, depends, members, unknowns);
        if (!solved) return solved.diagnostics();
        for (SolutionBlock& block : *solved) blocks.push_back(std::move(block));
    }
    return blocks;
}

}  // namespace analogon
