// SPDX-License-Identifier: LGPL-2.1-or-later
// How long the element kernels take on one core, and what part that is of what
// the core can do.
#include <lumbricus/anatomy/tissue.h>
#include <lumbricus/core/mpi_session.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/tangent.h>
#include <lumbricus/linear/mumps.h>
#include <lumbricus/program/blas.h>
#include <lumbricus/reference_map/active_stretch.h>
#include <lumbricus/reference_map/fluid_reset.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <exception>
#include <iomanip>
#include <iostream>
#include <memory>

#include "machine.h"
#include "operations.h"

using namespace lumbricus;

namespace
{
  // A cube of cells with all that the kernels read, and a smooth deformation.
  class Block
  {
  public:
    explicit Block(const unsigned int n_cells_per_edge)
      : space(triangulation)
      , shapes(space)
      , unknowns(space)
      , tangent(space, shapes, unknowns)
    {
      dealii::GridGenerator::subdivided_hyper_cube(triangulation,
                                                   n_cells_per_edge);
      space.distribute_dofs();
      shapes.reinit();
      dealii::AffineConstraints<double> none(space.locally_relevant);
      none.close();
      unknowns.reinit(none);
      tangent.reinit();

      const dealii::FE_Q<dim> q2(MixedSpace::degree);
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          std::array<double, CellUnknowns::n_per_cell> x;
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            {
              const auto X = space.mapping.transform_unit_to_real_cell(
                cell, q2.unit_support_point(n));
              for (unsigned int c = 0; c < dim; ++c)
                x[CellUnknowns::displacement(c, n)] =
                  0.1 * std::sin(2. * X[(c + 1) % dim] + 3. * X[c] + c);
            }
          for (unsigned int m = 0; m < MixedSpace::n_pressure_modes; ++m)
            x[CellUnknowns::pressure(m)] = 0.01 * (m + 1.);
          state.push_back(x);
        }
    }

    unsigned int
    n_cells() const
    {
      return shapes.n_owned_cells();
    }

    dealii::Triangulation<dim> triangulation;
    MixedSpace                 space;
    ShapeCache                 shapes;
    CellUnknowns               unknowns;
    Tangent                    tangent;

    std::vector<std::array<double, CellUnknowns::n_per_cell>> state;
  };



  struct Material
  {
    std::string             name;
    std::unique_ptr<Tissue> tissue;
    ReferencePoint          reference;
    operations::Law         operations;
  };



  std::unique_ptr<Tissue>
  make_tissue(const std::string &law)
  {
    dealii::ParameterHandler prm;
    auto                     tissue = std::make_unique<Tissue>("tissue");
    tissue->declare_parameters(prm);
    prm.set("Law", law);
    tissue->extend_parameters(prm, Extent::chosen);
    tissue->initialize({});
    return tissue;
  }



  std::vector<Material>
  make_materials()
  {
    using namespace operations;
    const ActiveFibre      fibre{dealii::Point<dim>(0.6, 0., 0.8), 0.8};
    dealii::Tensor<2, dim> F_r = dealii::unit_symmetric_tensor<dim>();
    F_r[0][1]                  = 0.3;
    F_r[2][2]                  = 0.9;

    std::vector<Material> all;
    all.push_back({"wall, Neo-Hooke", make_tissue("Neo-Hooke"), {}, neo_hooke});
    all.push_back(
      {"wall, Mooney-Rivlin", make_tissue("Mooney-Rivlin"), {}, mooney_rivlin});
    all.push_back({"muscle, Neo-Hooke",
                   make_tissue("Neo-Hooke"),
                   active_stretch_map({fibre}),
                   neo_hooke});
    all.push_back({"liquid, Neo-Hooke",
                   make_tissue("Neo-Hooke"),
                   rest_shape_map(F_r, F_r),
                   neo_hooke});
    return all;
  }



  // The least time per cell of a few cells in a row, over all of them, which no
  // cache holds, and some rounds: what else the machine does counts little.
  template <typename OnCell>
  double
  seconds_per_cell(const Block &block, const OnCell &on_cell)
  {
    constexpr unsigned int n_rounds = 10, batch = 64;
    double                 least = std::numeric_limits<double>::max();
    for (unsigned int round = 0; round < n_rounds; ++round)
      for (unsigned int i = 0; i + batch <= block.n_cells(); i += batch)
        least = std::min(least, machine::least_seconds(1, [&]() {
                           for (unsigned int k = i; k < i + batch; ++k)
                             on_cell(k);
                         }));
    return least / batch;
  }



  void
  print_kernel(const std::string &cell,
               const std::string &kernel,
               const double       seconds,
               const double       n_operations,
               const double       peak)
  {
    const double gigaflops = 1e-9 * n_operations / seconds;
    std::cout << "| " << cell << " | " << kernel << " | "
              << std::setprecision(4) << 1e3 * seconds << " | "
              << std::setprecision(1) << gigaflops << " | "
              << std::setprecision(0) << 100. * gigaflops / peak << " % |\n"
              << std::flush;
  }



  // The bandwidth of what is bound by it. More than that of the triad is
  // possible: a processor reads what it is about to write, and triad counts
  // that once.
  void
  print_bandwidth(const std::string &what,
                  const double       seconds,
                  const double       bytes,
                  const double       peak)
  {
    std::cout << "| " << what << " | " << std::setprecision(4) << 1e3 * seconds
              << " | " << std::setprecision(1) << 1e-9 * bytes / seconds
              << " | " << std::setprecision(0)
              << 100e-9 * bytes / seconds / peak << " % |\n"
              << std::flush;
  }



  // That the operator is that of the matrix, lest fast nonsense is measured.
  void
  check(const Block &block)
  {
    constexpr unsigned int n = CellUnknowns::n_per_cell;
    std::vector<double>    K;
    double                 y[n];
    const double          *x = block.state.front().data();
    block.tangent.cell_matrix(0, K);
    block.tangent.vmult_cell(0, x, y);
    double error = 0., size = 0.;
    for (unsigned int r = 0; r < n; ++r)
      {
        double sum = 0.;
        for (unsigned int s = 0; s < n; ++s)
          sum += K[r * n + s] * x[s];
        error = std::max(error, std::abs(sum - y[r]));
        size  = std::max(size, std::abs(y[r]));
      }
    AssertThrow(size > 0. && error < 1e-12 * size,
                dealii::ExcMessage("The operator is not that of the matrix."));
  }



  void
  measure_element(Block &block, const Material &material, const double peak)
  {
    const double                    *psi = block.shapes.pressure_modes();
    const std::vector<MaterialPoint> points(MixedSpace::n_q_points,
                                            {material.reference, {}});
    ElementKernel                    kernel;
    std::vector<double>              K;

    const auto evaluate = [&](const unsigned int i, CellLinearisation *to) {
      kernel.set(block.state[i].data());
      const double min_J = kernel.evaluate(
        block.shapes.cell(i), psi, *material.tissue, points.data(), to);
      AssertThrow(min_J > 0., dealii::ExcMessage("A cell is inside out."));
    };
    const double residual =
      seconds_per_cell(block, [&](const auto i) { evaluate(i, nullptr); });
    const double linearisation = seconds_per_cell(block, [&](const auto i) {
      evaluate(i, &block.tangent.cell(i));
    });
    const double matrix        = seconds_per_cell(block, [&](const auto i) {
      block.tangent.cell(i).matrix(block.shapes.cell(i), psi, true, K);
    });
    double       y[CellUnknowns::n_per_cell];
    const double vmult = seconds_per_cell(block, [&](const auto i) {
      block.tangent.cell(i).vmult(block.shapes.cell(i),
                                  psi,
                                  block.state[i].data(),
                                  y);
    });
    check(block);

    using namespace operations;
    const auto print = [&](const std::string &name,
                           const double       seconds,
                           const double       n_operations) {
      print_kernel(material.name, name, seconds, n_operations, peak);
    };
    const auto &law = material.operations;
    print("residual", residual, operations::residual(law));
    print("residual and linearisation",
          linearisation,
          operations::linearisation(law));
    print("element matrix", matrix, operations::matrix);
    print("element tangent and residual",
          linearisation + matrix,
          operations::linearisation(law) + operations::matrix);
    print("application of the tangent", vmult, operations::vmult);
  }



  // The operator as solvers apply it: per cell, and on vectors, which adds the
  // reading and adding up of the cells' unknowns.
  void
  measure_operator(const Block &block, const double peak)
  {
    using operations::vmult_bytes;
    double       y[CellUnknowns::n_per_cell];
    const double on_cell = seconds_per_cell(block, [&](const auto i) {
      block.tangent.vmult_cell(i, block.state[i].data(), y);
    });
    print_bandwidth("application of the tangent, per cell",
                    on_cell,
                    vmult_bytes,
                    peak);

    Vector from, to;
    block.unknowns.reinit_vector(from);
    block.unknowns.reinit_vector(to);
    from = 1.;
    const double on_vectors =
      machine::least_seconds(20, [&]() { block.tangent.vmult(to, from); });
    print_bandwidth("application to vectors, per cell",
                    on_vectors / block.n_cells(),
                    vmult_bytes,
                    peak);
  }



  // A solution with the factors of the matrix, which reads them twice. Nothing
  // is held, so the diagonal is increased to keep the matrix from being
  // singular.
  template <typename Number>
  void
  measure_substitution(Block             &block,
                       const Material    &material,
                       const std::string &precision,
                       const double       peak)
  {
    constexpr unsigned int           n = CellUnknowns::n_per_cell;
    const std::vector<MaterialPoint> points(MixedSpace::n_q_points,
                                            {material.reference, {}});
    FreeNumbering                    numbering;
    numbering.reinit(block.unknowns, true, MPI_COMM_SELF);
    Mumps<Number> mumps(MPI_COMM_SELF, {true, true, 0.}, numbering);
    mumps.analyse(block.unknowns, block.n_cells(), 0);
    mumps.begin();
    ElementKernel       kernel;
    std::vector<double> K;
    for (unsigned int i = 0; i < block.n_cells(); ++i)
      {
        kernel.set(block.state[i].data());
        kernel.evaluate(block.shapes.cell(i),
                        block.shapes.pressure_modes(),
                        *material.tissue,
                        points.data(),
                        &block.tangent.cell(i));
        block.tangent.cell_matrix(i, K);
        for (unsigned int r = 0; r < n; ++r)
          K[r * n + r] *= 1.1;
        mumps.add(n, K.data());
      }
    mumps.factor();
    std::vector<Number> values(numbering.n_owned());
    const double        seconds = machine::least_seconds(20, [&]() {
      std::fill(values.begin(), values.end(), Number(1));
      mumps.solve(values);
    });
    print_bandwidth("back substitution, " + precision + ", " +
                      std::to_string(numbering.size()) + " unknowns",
                    seconds,
                    2. * sizeof(Number) * mumps.factor_entries(),
                    peak);
  }



  void
  measure()
  {
    const double flops_peak = machine::gigaflops_of_dgemm();
    const double bytes_peak = machine::gigabytes_per_second_of_triad();
    std::cout << std::fixed << std::setprecision(1)
              << "One core: " << flops_peak << " GFLOP/s (dgemm), "
              << bytes_peak << " GB/s (triad).\n\n";

    const auto materials = make_materials();
    {
      Block block(16);
      std::cout << "| cell | kernel | time (ms) | GFLOP/s | of dgemm |\n"
                << "|---|---|---|---|---|\n";
      for (const Material &material : materials)
        measure_element(block, material, flops_peak);
      std::cout << "\n| operator | time (ms) | GB/s | of triad |\n"
                << "|---|---|---|---|\n";
      measure_operator(block, bytes_peak);
    }
    Block block(10);
    measure_substitution<double>(block,
                                 materials.front(),
                                 "double precision",
                                 bytes_peak);
    measure_substitution<float>(block,
                                materials.front(),
                                "single precision",
                                bytes_peak);
  }
} // namespace



int
main(int, char **argv)
{
  prepare_blas(argv);
  try
    {
      const MpiSession session(argv[0]);
      std::cerr << blas_warning();
      measure();
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << "\n";
      return 1;
    }
  return 0;
}
