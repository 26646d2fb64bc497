// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/geometry/segment_ranges.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <algorithm>
#include <map>
#include <optional>

#include "chain_layout.h"
#include "coarse_cells.h"
#include "extrusion.h"
#include "measure_table.h"
#include "round_section.h"
#include "segment_measures.h"

namespace lumbricus
{
  namespace
  {
    const std::string ranges_name = "Segments with their own measures";
  } // namespace



  /**
   * A chain of liquid-filled segments along the x axis, from the head at x = 0
   * to the tail:
   *
   *        __________________________________________________
   *   |   |______________________wall________________________|   |
   *   |cap|  liquid 1  |septum|  liquid 2  |septum| ...      |cap|
   *   |   |      .. x axis ..
   *
   * The wall goes on around the septa; the caps close its ends over the whole
   * section. Where radii change along chambers these are cones; caps may be cones
   * too. A septum consists of two halves, each a part of the segment it
   * closes. The sections a segment is measured between are the middles of its
   * septa, and the inner faces of the caps. A septum of one cell is no two
   * halves: it belongs to the segment before it, which is measured to its rear
   * face.
   */
  class SegmentChain : public Geometry
  {
  public:
    SegmentChain();

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    void
    create_coarse_mesh(
      dealii::Triangulation<dim> &triangulation) const override;

    unsigned int
    n_segments() const override
    {
      return n;
    }

    std::vector<TissueName>
    tissues() const override;

    std::vector<std::string>
    boundary_names() const override
    {
      return {"head", "tail", "skin"};
    }

    std::vector<CavityWall>
    cavities() const override;

    std::vector<SymmetryPlane>
    symmetry_planes() const override
    {
      return section.symmetry_planes(n_boundaries);
    }

    std::string
    way_without_symmetry() const override
    {
      return "Set 'Geometry/segment chain/Cross-section' to 'full'.";
    }

    std::vector<SegmentSections>
    sections() const override
    {
      return layout().sections;
    }

    std::array<dealii::Point<dim>, 3>
    support_points() const override;

    double
    characteristic_length() const override;

  private:
    inline static const std::string path = "Geometry/segment chain";

    // The boundary ids; those of the symmetry planes follow, and then those of
    // the cavities.
    enum Boundary : unsigned int
    {
      head,
      tail,
      skin,
      n_boundaries
    };

    std::vector<SegmentRange>
    ranges() const
    {
      return parse_segment_ranges(path + "/" + ranges_name, range_list);
    }

    /** The measures of every segment, once all parameters are read. */
    const std::vector<SegmentMeasures> &
    measures() const;

    /** The same, found anew. Throws ExcParameter. */
    std::vector<SegmentMeasures>
    find_measures() const;

    ChainLayout
    layout() const;

    RoundSection    section;
    MeasureFormulas common;
    std::string     table_file;
    std::string     range_list;

    /** By name of the section. The addresses of its values stay as they are. */
    std::map<std::string, MeasureFormulas> own_measures;

    /** What measures() has found. */
    mutable std::vector<SegmentMeasures> found;

    std::string  taper         = "in septa";
    unsigned int n             = 3;
    double       cap_thickness = 0.3;
    double       tip_factor    = 1.;
    unsigned int n_along       = 2;
    unsigned int n_half_septum = 1;
    unsigned int n_cap         = 1;
  };



  SegmentChain::SegmentChain()
    : section(path, {"liquid", "septum", "cap"})
  {}



  void
  SegmentChain::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Number of segments",
                      n,
                      "[number] Segments of the chain. They are counted from "
                      "1 at the head (x = 0) towards the tail.",
                      dealii::Patterns::Integer(1, 10000));
    common.declare_parameters(prm);
    prm.add_parameter(MeasureTable::entry,
                      table_file,
                      "[path] A text file with measures along the chain, which "
                      "stand in place of the formulas: columns separated by "
                      "commas, with names in the first line. The first is "
                      "'place', (s - 1/2)/n from 0 at the head to 1 at the "
                      "tail, or 's'; others are 'Radius', 'Segment length', "
                      "'Septum thickness', and the name of any layer of the "
                      "wall for its thickness. Linear between rows. Empty: no "
                      "table.",
                      dealii::Patterns::FileName());
    prm.add_parameter("Taper",
                      taper,
                      "Where the radii change from one segment to the next. 'in "
                      "septa': from one side of a septum to the other, so that "
                      "chambers are cylinders. 'along chambers': from the mean "
                      "of two neighbours at the septum between them to a "
                      "segment's own in its middle.",
                      dealii::Patterns::Selection("in septa|along chambers"));
    prm.add_parameter("Cap thickness",
                      cap_thickness,
                      "[mm] Thickness of the caps that close the chain at its "
                      "head and at its tail.",
                      PositiveNumber());
    prm.add_parameter("Tip of the caps",
                      tip_factor,
                      "[1] All radii at the outer face of a cap, relative to "
                      "those at its inner face: with less than 1 the body has "
                      "no sharp rim that catches on an obstacle.",
                      dealii::Patterns::Double(0.05, 1.));
    prm.add_parameter(
      ranges_name,
      range_list,
      "[numbers] Segments that differ from the others: a list of "
      "numbers and ranges like '1, 8-10'. Each item has a section "
      "('Segment 1', 'Segments 8-10') with the measures of these segments; "
      "what is not set there is as for the whole chain.");
    section.declare_parameters(prm);
    prm.add_parameter("Cells along a segment",
                      n_along,
                      "[number] Cells along the liquid chamber of a segment; "
                      "even where that is meshed.",
                      dealii::Patterns::Integer(1));
    prm.add_parameter("Cells through half a septum",
                      n_half_septum,
                      "[number] Cells through each of the two halves of a "
                      "septum. 0: one cell through all of it, which belongs to "
                      "the segment in front of it.",
                      dealii::Patterns::Integer(0));
    prm.add_parameter("Cells through a cap",
                      n_cap,
                      "[number] Cells through the thickness of a cap.",
                      dealii::Patterns::Integer(1));
  }



  bool
  SegmentChain::extend_parameters(dealii::ParameterHandler &prm,
                                  const Extent              extent)
  {
    const auto all = extent == Extent::everything ?
                       std::vector<SegmentRange>{{8, 10}} :
                       ranges();

    bool extended = false;
    for (const SegmentRange &range : all)
      {
        const auto entry = own_measures.emplace(range.name(), common);
        if (entry.second)
          {
            prm.enter_subsection(range.name());
            entry.first->second.declare_parameters(prm);
            prm.leave_subsection();
            extended = true;
          }
      }
    return extended;
  }



  void
  SegmentChain::check_parameters() const
  {
    section.check_parameters();
    check_n_coarse_cells(path,
                         section.n_cells(true) *
                           (double(n) * n_along + 2. * n_cap +
                            (n - 1.) * std::max(1., 2. * n_half_septum)));
    range_of_segments(path + "/" + ranges_name, ranges(), n);
    section.check_thicknesses(path, common.n_layers());
    within_section(path, [&]() { common.check_parameters(); });
    for (const SegmentRange &range : ranges())
      {
        const MeasureFormulas &own = own_measures.at(range.name());
        section.check_thicknesses(path + "/" + range.name(), own.n_layers());
        within_section(path + "/" + range.name(),
                       [&]() { own.check_parameters(); });
      }
    found = find_measures();
    for (const SegmentMeasures &segment : found)
      if (segment.liquid == "meshed")
        RoundSection::check_even(path,
                                 "Cells along a segment",
                                 n_along,
                                 "faces of the mesh have to lie in the middle "
                                 "of a segment whose liquid is meshed, where "
                                 "it is measured");
  }



  const std::vector<SegmentMeasures> &
  SegmentChain::measures() const
  {
    if (found.size() != n)
      found = find_measures();
    return found;
  }



  std::vector<SegmentMeasures>
  SegmentChain::find_measures() const
  {
    const auto all      = ranges();
    const auto range_of = range_of_segments(path + "/" + ranges_name, all, n);
    MeasureTable table;
    if (!table_file.empty())
      within_section(path, [&]() {
        table =
          MeasureTable(table_file, common.names(section.layer_names()));
      });

    std::vector<SegmentMeasures> result(n);
    for (unsigned int s = 0; s < n; ++s)
      {
        within_section(path, [&]() {
          result[s] = common.of(s + 1, n, table, section.layer_names());
        });
        if (range_of[s] == all.size())
          continue;
        const std::string name = all[range_of[s]].name();
        within_section(path + "/" + name, [&]() {
          result[s] = own_measures.at(name).of(s + 1, n, common, result[s]);
        });
      }
    return result;
  }



  ChainLayout
  SegmentChain::layout() const
  {
    const auto &segments = measures();
    const auto  radii    = [&](const unsigned int s) {
      return RoundSection::ring_radii(segments[s].radius,
                                      segments[s].layer_thicknesses);
    };
    const auto between = [&](const unsigned int s) {
      return ChainLayout::mean(radii(s), radii(s + 1), 0.5);
    };
    const bool is_gradual = taper == "along chambers";
    const bool has_halves = n_half_septum > 0;

    const auto tip = [&](std::vector<double> of_cap) {
      for (double &radius : of_cap)
        radius *= tip_factor;
      return of_cap;
    };

    ChainLayout layout(tip(radii(0)));
    layout.append(cap_thickness, n_cap, radii(0), {0, ChainSlab::Filling::cap});
    double begin = layout.end();
    for (unsigned int s = 0; s < n; ++s)
      {
        const auto front = is_gradual && s > 0 ? between(s - 1) : radii(s);
        const auto rear  = is_gradual && s + 1 < n ? between(s) : radii(s);
        const double middle = layout.end() + segments[s].length / 2;
        for (unsigned int i = 1; i <= n_along; ++i)
          {
            const double f = 2. * i / n_along;
            layout.append(segments[s].length / n_along,
                          1,
                          f < 1. ? ChainLayout::mean(front, radii(s), f) :
                                   ChainLayout::mean(radii(s), rear, f - 1.),
                          {s, ChainSlab::Filling::liquid});
          }
        if (s + 1 == n)
          {
            layout.sections.push_back({begin, middle, layout.end()});
            layout.append(cap_thickness,
                          n_cap,
                          tip(radii(s)),
                          {s, ChainSlab::Filling::cap});
            break;
          }
        const auto   next   = is_gradual ? between(s) : radii(s + 1);
        const double septum = segments[s].septum_thickness;
        layout.append(has_halves ? septum / 2 : septum,
                      has_halves ? n_half_septum : 1,
                      has_halves ? between(s) : next,
                      {s, ChainSlab::Filling::septum});
        layout.sections.push_back({begin, middle, layout.end()});
        begin = layout.end();
        if (has_halves)
          layout.append(septum / 2,
                        n_half_septum,
                        next,
                        {s + 1, ChainSlab::Filling::septum});
      }
    return layout;
  }



  void
  SegmentChain::create_coarse_mesh(
    dealii::Triangulation<dim> &triangulation) const
  {
    const ChainLayout  plan       = layout();
    const unsigned int n_layers   = section.n_layers();
    const bool         has_liquid = tissues()[0].liquid;

    // The boundaries of the chambers without cells, by segment.
    std::map<unsigned int, dealii::types::boundary_id> walls;
    for (const CavityWall &wall : cavities())
      walls[wall.segment] = wall.boundary;

    // In the order of tissues().
    const auto region = [&](const unsigned int slab, const unsigned int ring) {
      const ChainSlab   &where  = plan.slabs[slab];
      const unsigned int septum = n_layers + 1;
      const unsigned int cap    = n > 1 ? septum + 1 : septum;
      const unsigned int place =
        where.filling == ChainSlab::Filling::cap    ? cap :
        ring > 0                                    ? ring :
        where.filling == ChainSlab::Filling::septum ? septum :
                                                      0;
      if (place == 0 && walls.count(where.segment) > 0)
        return std::optional<Region>();
      return std::make_optional(
        Region{where.segment, has_liquid ? place : place - 1});
    };

    const auto boundary =
      [&](const BodySurface surface,
         const unsigned int /*ring*/,
         const unsigned int slab) -> dealii::types::boundary_id {
      switch (surface)
        {
          case BodySurface::chamber:
            return walls.at(plan.slabs[slab].segment);
          case BodySurface::head:
            return head;
          case BodySurface::tail:
            return tail;
          case BodySurface::outer:
            return skin;
          default:
            return RoundSection::symmetry_boundary(surface, n_boundaries);
        }
    };

    extrude(section.cross_section(true),
            plan.stations,
            region,
            boundary,
            triangulation);
  }



  std::vector<TissueName>
  SegmentChain::tissues() const
  {
    std::vector<TissueName> all;
    if (cavities().size() < n)
      all.push_back({"liquid", true});
    section.append_layers(all);
    if (n > 1)
      all.push_back({"septum", false});
    all.push_back({"cap", false});
    return all;
  }



  std::vector<CavityWall>
  SegmentChain::cavities() const
  {
    const auto             &segments = measures();
    unsigned int            next     = n_boundaries + symmetry_planes().size();
    std::vector<CavityWall> all;
    for (unsigned int s = 0; s < n; ++s)
      if (segments[s].liquid == "cavity")
        all.push_back({next++, s});
    return all;
  }



  std::array<dealii::Point<dim>, 3>
  SegmentChain::support_points() const
  {
    const ChainLayout plan = layout();
    return {{dealii::Point<dim>(0., 0., 0.),
             dealii::Point<dim>(plan.end(), 0., 0.),
             dealii::Point<dim>(0., 0., plan.stations[0].radii.back())}};
  }



  double
  SegmentChain::characteristic_length() const
  {
    double largest = 0.;
    for (const SegmentMeasures &segment : measures())
      largest = std::max(largest, segment.radius);
    return largest;
  }



  static const Register<Geometry, SegmentChain>
    segment_chain("segment chain",
                  "a row of liquid-filled segments with a wall of layers, "
                  "separated by septa and closed by a cap at either end.");
} // namespace lumbricus
