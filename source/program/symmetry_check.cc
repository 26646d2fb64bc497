// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/parameters/expression.h>
#include <lumbricus/program/symmetry_check.h>

#include <deal.II/base/numbers.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "elastic_fibre_symmetry.h"
#include "plane_of_symmetry.h"

namespace lumbricus
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    // More points than these of one kind on one rank are not looked at again
    // and again, at all times.
    constexpr std::size_t most_points = 200;

    using Plane                = PlaneOfSymmetry;
    constexpr double tolerance = Plane::tolerance;



    // A point of a plane in a tissue with muscles.
    struct MusclePoint
    {
      Point<dim>                         X;
      unsigned int                       segment;
      const std::vector<const Muscle *> *muscles;
      std::vector<Tensor<1, dim>>        mixed; ///< e . M t, of every muscle
      std::vector<double>                angle; ///< with the plane [degrees]
      std::vector<double>                slack; ///< what mixed may be off by
    };



    // Faces, every so many, so that they are not too many.
    template <typename Entry>
    void
    thin_out(std::vector<Entry> &entries)
    {
      const std::size_t stride = 1 + entries.size() / most_points;
      for (std::size_t i = 0; i * stride < entries.size(); ++i)
        std::swap(entries[i], entries[i * stride]);
      entries.resize((entries.size() + stride - 1) / stride);
    }



    std::vector<Plane>
    planes_of(const Geometry &geometry, const MixedSpace &space)
    {
      std::vector<Plane> planes;
      for (const SymmetryPlane &plane : geometry.symmetry_planes())
        {
          double c = plane.position(space.triangulation);
          // Rounding of the mesh.
          if (std::abs(c) < 1e-12 * geometry.characteristic_length())
            c = 0.;
          planes.push_back({plane.direction, plane.boundary, c});
        }
      return planes;
    }



    // Set what there is of the muscles at a point: of the entries of 3/2 f x f
    // those that mix e and the plane have to vanish. @return whether all are
    // symmetric however much they contract; ExcInput where fibres have no
    // direction.
    bool
    look_at_fibres(MusclePoint &point, const unsigned int d)
    {
      bool symmetric = true;
      for (const Muscle *muscle : *point.muscles)
        {
          const auto f     = muscle->fibre_direction(point.X);
          auto       mixed = 1.5 * f[d] * f;
          mixed[d]         = 0.;
          const double slack = 1.5 * muscle->fibres().error(point.X);
          symmetric = symmetric && mixed.norm() <= tolerance + slack;
          point.mixed.push_back(mixed);
          point.slack.push_back(slack);
          point.angle.push_back(std::asin(std::min(1., std::abs(f[d]))) * 180. /
                                dealii::numbers::PI);
        }
      return symmetric;
    }



    std::vector<MusclePoint>
    doubtful_points(const Plane      &plane,
                    const MixedSpace &space,
                    const Anatomy    &anatomy)
    {
      std::vector<MusclePoint> points;
      const auto look = [&](const Region region, const Point<dim> &X) {
        if (anatomy.muscles_of(region.tissue).empty())
          return;
        MusclePoint point;
        point.X       = X;
        point.segment = region.segment + 1;
        point.muscles = &anatomy.muscles_of(region.tissue);
        if (!look_at_fibres(point, plane.direction))
          points.push_back(point);
      };
      for_each_point_of(plane, space, look);
      thin_out(points);
      return points;
    }



    // What the muscles of one action do together at a point and a time.
    struct JointAction
    {
      Tensor<1, dim> sum;        ///< of strength times e . M t
      double         all   = 0.; ///< sum of strengths
      double         slack = 0.; ///< that sampling may need
      unsigned int   n     = 0;  ///< muscles that are not symmetric alone
      std::string    who;        ///< their names, and what they do
    };



    JointAction
    act_together(const MusclePoint &point,
                 const std::string &action,
                 const double       t)
    {
      JointAction        joint;
      std::ostringstream who;
      who.precision(3);
      for (unsigned int m = 0; m < point.muscles->size(); ++m)
        {
          const Muscle &muscle = *(*point.muscles)[m];
          if (muscle.action_name() != action)
            continue;
          const double activation = muscle.activation(t, point.segment, point.X);
          const double tension =
            muscle.fibre_at_rest(point.segment, point.X).largest_tension;
          const double strength = muscle.action().strength(activation, tension);
          joint.sum += strength * point.mixed[m];
          joint.all += std::abs(strength);
          joint.slack += std::abs(strength) * point.slack[m];
          if (std::abs(strength) * point.mixed[m].norm() <=
              tolerance * joint.all)
            continue;
          who << (joint.n++ == 0 ? "'" : ", '") << muscle.name()
              << "' (fibres at " << point.angle[m] << " degrees to it, "
              << muscle.action().quantity() << " " << activation;
          if (tension > 0.)
            who << " of " << tension << " N/mm^2";
          who << ")";
        }
      joint.who = who.str();
      return joint;
    }



    // What is wrong with the muscles at a plane; empty where nothing is.
    std::string
    asymmetric_muscles(const Plane               &plane,
                       const MixedSpace          &space,
                       const Anatomy             &anatomy,
                       const std::vector<double> &times)
    {
      std::set<std::string> actions;
      for (unsigned int m = 0; m < anatomy.n_muscles(); ++m)
        actions.insert(anatomy.muscle(m).action_name());
      for (const MusclePoint &point : doubtful_points(plane, space, anatomy))
        for (const double t : times)
          for (const std::string &action : actions)
            {
              const JointAction joint = act_together(point, action, t);
              if (!(joint.sum.norm() > tolerance * joint.all + joint.slack))
                continue;
              std::ostringstream message;
              message << (joint.n == 1 ? "The muscle " : "The muscles ")
                      << joint.who
                      << (joint.n == 1 ? " is" : " together are")
                      << " not symmetric to " << plane.name() << ": at time "
                      << t << " at its point " << point_text(point.X)
                      << ", where fibres have to be at 0 or 90 degrees to it, "
                         "or crossed and equally active. "
                      << anatomy.geometry().way_without_symmetry()
                      << Plane::way_without_check();
              return message.str();
            }
      return "";
    }



    // The faces of a boundary that end at a plane: where their nodes are.
    struct EdgeFace
    {
      std::vector<SurfacePoint> nodes;
      std::vector<bool>         on_plane;
    };



    std::vector<EdgeFace>
    faces_at_plane(const Plane                     &plane,
                   const dealii::types::boundary_id id,
                   const MixedSpace                &space,
                   const double                     length)
    {
      const dealii::QGaussLobatto<dim - 1> nodes(3);
      dealii::FEFaceValues<dim>            face_values(space.mapping,
                                            space.fe,
                                            nodes,
                                            dealii::update_quadrature_points |
                                              dealii::update_normal_vectors);
      std::vector<EdgeFace>                faces;
      for_each_boundary_face(space, [&](const auto &cell, const auto &face) {
        if (face->boundary_id() != id)
          return;
        const auto on_plane = [&](const Point<dim> &X) {
          return std::abs(X[plane.direction] - plane.c) < 1e-6 * length;
        };
        bool any = false;
        for (unsigned int v = 0; v < 4; ++v)
          any = any || on_plane(face->vertex(v));
        if (!any)
          return;
        face_values.reinit(mesh_cell(cell), face);
        EdgeFace at_plane;
        for (const unsigned int q : face_values.quadrature_point_indices())
          {
            SurfacePoint point;
            point.X = face_values.quadrature_point(q);
            point.N = face_values.normal_vector(q);
            point.F = dealii::unit_symmetric_tensor<dim, double>();
            point.segment = Region::of(cell->material_id()).segment;
            at_plane.nodes.push_back(point);
            at_plane.on_plane.push_back(on_plane(point.X));
          }
        faces.push_back(at_plane);
      });
      thin_out(faces);
      return faces;
    }



    Tensor<1, dim>
    traction(const SurfaceTerm &term, SurfacePoint point, const double t)
    {
      SurfaceResponse response;
      point.t = t;
      term.surface(point, response);
      return response.T;
    }



    std::string
    asymmetric_load(const NamedCondition      &load,
                    const Plane               &plane,
                    const MixedSpace          &space,
                    const Anatomy             &anatomy,
                    const std::vector<double> &times,
                    const bool                 tractions_too)
    {
      const SurfaceTerm *const term = load.surface_term();
      const auto *const  held       = load.prescribed_displacement();
      const unsigned int d          = plane.direction;
      const double length  = anatomy.geometry().characteristic_length();
      const bool   pulls   = tractions_too && term != nullptr;
      const bool   is_held = held != nullptr && held->components()[d];
      if (!pulls && !is_held)
        return "";

      for (const EdgeFace &face :
           faces_at_plane(plane, load.boundary, space, length))
        for (const double t : times)
          for (unsigned int q = 0; q < face.nodes.size(); ++q)
            {
              if (!face.on_plane[q])
                continue;
              SurfacePoint point = face.nodes[q];
              point.t            = t;
              std::ostringstream what;
              if (is_held)
                {
                  const double u = held->value(d, point.X, t);
                  if (std::abs(u) > 1e-6 * length)
                    what << "its displacement along the normal, u" << "xyz"[d]
                         << " = " << u << " mm, has to be zero there";
                }
              if (pulls)
                {
                  // A traction along the surface's normal is as symmetric as
                  // the surface.
                  const auto   T = traction(*term, point, t);
                  const double off =
                    std::min(std::abs(T[d]),
                             std::abs((T - (T * point.N) * point.N)[d]));
                  double most = 0.;
                  if (off > 0.)
                    for (const SurfacePoint &node : face.nodes)
                      most =
                        std::max(most, traction(*term, node, t).norm());
                  if (off > tolerance * most)
                    what << "its traction along the normal, T" << "xyz"[d]
                         << " = " << T[d]
                         << " N/mm^2, has to be zero there";
                }
              if (pulls)
                for (const Tensor<1, dim> &e : term->possible_directions(point))
                  if (std::abs(e[d]) > tolerance && what.str().empty())
                    what << "it may pull along " << point_text(Point<dim>(e))
                         << ", and not only within that plane";
              if (what.str().empty())
                continue;
              std::ostringstream message;
              message << "The boundary condition '" << load.name
                      << "' is not symmetric to " << plane.name()
                      << ": at time " << t << " at " << point_text(point.X)
                      << " " << what.str() << ". "
                      << anatomy.geometry().way_without_symmetry();
              return message.str();
            }
      return "";
    }
    std::string
    asymmetric_force(const NamedBodyForce      &force,
                     const Plane               &plane,
                     const MixedSpace          &space,
                     const Anatomy             &anatomy,
                     const std::vector<double> &times)
    {
      // The middle of faces on the plane.
      std::vector<Point<dim>> points;
      for_each_boundary_face(space, [&](const auto &cell, const auto &face) {
        if (face->boundary_id() == plane.boundary &&
            force.acts_in[Region::of(cell->material_id()).tissue])
          points.push_back(face->center());
      });
      thin_out(points);

      const unsigned int d = plane.direction;
      for (const Point<dim> &X : points)
        for (const double t : times)
          {
            VolumePoint point;
            point.X = X;
            point.t = t;
            point.density = 1.;
            VolumeResponse response;
            force.type->volume(point, response);
            if (!(std::abs(response.b[d]) > tolerance * response.b.norm()))
              continue;
            std::ostringstream message;
            message << "The body force '" << force.name
                    << "' is not symmetric to " << plane.name()
                    << ": at time " << t << " at " << point_text(X)
                    << " its part along the normal, b" << "xyz"[d] << " = "
                    << response.b[d] << " N/mm^3, has to be zero there. "
                    << anatomy.geometry().way_without_symmetry();
            return message.str();
          }
      return "";
    }
  } // namespace



  void
  SymmetryCheck::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Boundary conditions");
    prm.add_parameter("Check symmetry",
                      required,
                      "Whether to refuse muscles, elastic fibres, tractions and "
                      "body forces that do not go on smoothly in the mirror "
                      "image of the body at a plane of symmetry, such as "
                      "helical fibres at a quarter of a cross-section. 'false' "
                      "where that mirror image is meant: the fibres of a "
                      "bipennate muscle.");
    prm.leave_subsection();
  }



  void
  SymmetryCheck::check(const MixedSpace          &space,
                       const Anatomy             &anatomy,
                       const BoundaryConditions  &conditions,
                       const BodyForces          &forces,
                       const std::vector<double> &times) const
  {
    std::string message;
    for (const Plane &plane : planes_of(anatomy.geometry(), space))
      try
        {
          if (required && message.empty())
            message = asymmetric_muscles(plane, space, anatomy, times);
          if (required && message.empty())
            message = asymmetric_elastic_fibres(plane, space, anatomy);
          for (unsigned int i = 0;
               i < conditions.n_conditions() && message.empty();
               ++i)
            message = asymmetric_load(
              conditions.condition(i), plane, space, anatomy, times, required);
          for (unsigned int i = 0;
               required && i < forces.n_forces() && message.empty();
               ++i)
            message =
              asymmetric_force(forces.force(i), plane, space, anatomy, times);
        }
      catch (const ExcInput &exception)
        {
          message = plain_message(exception);
        }
    throw_on_all_ranks<ExcInput>(message, space.communicator());
  }
} // namespace lumbricus
