package org.mechservice.view.player;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.mesh.Mesh;
import org.mechservice.view.mesh.MeshException;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.mesh.Solids;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneConstraint;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneJoint;
import org.mechservice.view.scene.SceneSolid;

/**
 * The shapes that show a mechanism: the surfaces of its bodies and joints, and the links between
 * points of bodies that rods and springs are drawn as.
 *
 * <p>A body without a geometry file is drawn as its solids, with rods to those of its joints that
 * are away from them. Without solids it gets rods that join its joints, and the box or cylinder of
 * even density that has its inertia. A body in contact by a sphere or a tyre gets that. Sizes of
 * symbols follow from the extent of the mechanism at the start.
 */
public final class Stage {
  private static final int[] PALETTE = {
    0x4c8bd6, 0xe39a3b, 0x5aa86b, 0xc9605e, 0x8f78c9, 0x3fa7ad, 0xb5884f, 0xd77fae
  };
  private static final int GROUND = 0x8a9099;
  private static final int JOINT = 0x59636e;
  private static final int SURFACE = 0x93a08f;

  /** Longest edge of a box that a body's inertia is drawn as, in parts of the extent. */
  private static final double LARGEST_BOX = 0.5;

  private final SceneDescription scene;
  private final MeshFolder folder;
  private final double extent;
  private final List<Part> parts = new ArrayList<>();
  private final List<Strut> links = new ArrayList<>();
  private final List<String> warnings = new ArrayList<>();
  private final Set<Surface> surfaces = new HashSet<>();

  /** A plane fixed in a body; several contacts may share it. */
  private record Surface(Anchor at, Point3 normal) {}

  /**
   * Sets up the stage.
   *
   * @param scene the mechanism
   * @param folder where the geometry files lie that it names
   */
  public Stage(SceneDescription scene, MeshFolder folder) {
    this.scene = scene;
    this.folder = folder;
    extent = extent(scene);
    for (int body = 0; body < scene.bodies().size(); body++) {
      addBody(body);
    }
    if (!addGeometry(Anchor.ROOT, scene.rootGeometry())) {
      addSolids(Anchor.ROOT, scene.rootSolids());
      addFixedPoints();
    }
    scene.joints().forEach(this::addJoint);
    scene.constraints().forEach(this::addConstraint);
    scene.forces().forEach(this::addForce);
  }

  /** Returns what could not be shown as the model asks for: one message each. */
  public List<String> warnings() {
    return List.copyOf(warnings);
  }

  /** Returns the surfaces. */
  List<Part> parts() {
    return List.copyOf(parts);
  }

  /** Returns the links. */
  List<Strut> links() {
    return List.copyOf(links);
  }

  /** Returns a length that symbols are in proportion to: the extent at the start, m. */
  double extent() {
    return extent;
  }

  /** Returns the colour of a body. */
  static int colour(int body) {
    return body == Anchor.ROOT ? GROUND : PALETTE[body % PALETTE.length];
  }

  private static double extent(SceneDescription scene) {
    double largest = 0;
    List<Point3> points = scene.extent();
    for (Point3 one : points) {
      largest = Math.max(largest, one.minus(points.get(0)).norm());
    }
    for (SceneBody body : scene.bodies()) {
      Point3 size = InertiaBox.of(body).size();
      largest = Math.max(largest, size.norm());
    }
    for (SceneForce force : scene.forces()) {
      largest = Math.max(largest, 4 * force.radius());
    }
    return largest > 0 && Double.isFinite(largest) ? largest : 1;
  }

  private void addBody(int index) {
    SceneBody body = scene.bodies().get(index);
    if (addGeometry(index, body.geometry())) {
      return;
    }
    if (addSolids(index, body.solids())) {
      balls(index).forEach(mesh -> add(index, Part.Role.BODY, body.name(), mesh));
      addRods(index, body);
    } else {
      shapes(index, body).forEach(mesh -> add(index, Part.Role.BODY, body.name(), mesh));
    }
  }

  /** Adds the surfaces of a geometry file; returns whether there are any. */
  private boolean addGeometry(int body, String file) {
    if (file.isEmpty()) {
      return false;
    }
    String name = scene.bodyName(body);
    try {
      folder.read(file).forEach(mesh -> add(body, Part.Role.BODY, name, mesh));
      return true;
    } catch (MeshException e) {
      warnings.add("body " + name + " is drawn as a simple shape: " + e.getMessage());
      return false;
    }
  }

  /** Adds the solids of a body; returns whether there are any that can be shown. */
  private boolean addSolids(int body, List<SceneSolid> solids) {
    String name = scene.bodyName(body);
    BodySurfaces surfacesOf = new BodySurfaces(folder, extent);
    boolean shown = false;
    for (SceneSolid solid : solids) {
      try {
        surfacesOf.of(solid).forEach(mesh -> add(body, Part.Role.BODY, name, mesh));
        shown = true;
      } catch (MeshException e) {
        warnings.add("a solid of body " + name + " is not drawn: " + e.getMessage());
      }
    }
    return shown;
  }

  /** Joins the points of a body that lie away from its solids to its centre of mass. */
  private void addRods(int index, SceneBody body) {
    double away = 0.03 * extent;
    for (Point3 point : points(index)) {
      if (body.solids().stream().allMatch(one -> BodySurfaces.distance(one, point) > away)) {
        Solids.rod(point, body.centreOfMass(), 0.006 * extent)
            .forEach(mesh -> add(index, Part.Role.BODY, body.name(), mesh));
      }
    }
  }

  private void add(int body, Part.Role role, String name, Mesh mesh) {
    int colour = role == Part.Role.JOINT ? JOINT : colour(body);
    boolean own = mesh.colour() != Mesh.NO_COLOUR;
    parts.add(new Part(body, role, name, mesh, own ? mesh.colour() : colour));
  }

  /** Returns the points of a body that something holds or pulls, in body axes, each once. */
  private List<Point3> points(int body) {
    List<Anchor> anchors = new ArrayList<>();
    for (SceneJoint joint : scene.joints()) {
      // a free joint holds nothing
      if (joint.type() != JointType.F) {
        anchors.add(joint.first());
        anchors.add(joint.second());
      }
    }
    for (SceneConstraint constraint : scene.constraints()) {
      anchors.addAll(constraint.anchors());
    }
    for (SceneForce force : scene.forces()) {
      if (force.kind() != SceneForce.Kind.CONTACT && force.joint().isEmpty()) {
        anchors.addAll(force.anchors());
      }
    }
    List<Point3> points = new ArrayList<>();
    for (Anchor anchor : anchors) {
      boolean known = points.stream().anyMatch(p -> p.minus(anchor.point()).norm() < 1e-6 * extent);
      if (anchor.body() == body && !known) {
        points.add(anchor.point());
      }
    }
    return points;
  }

  private List<Mesh> shapes(int index, SceneBody body) {
    List<Mesh> shapes = new ArrayList<>(balls(index));
    boolean massShown = !shapes.isEmpty() || !(body.mass() > 0);
    List<Point3> points = points(index);
    double radius = 0.012 * extent;
    InertiaBox box = InertiaBox.of(body);
    if (points.size() == 2) {
      shapes.addAll(Solids.rod(points.get(0), points.get(1), radius));
      massShown |= !bulky(box, points);
    } else {
      Point3 hub = body.mass() > 0 ? body.centreOfMass() : middle(points);
      points.forEach(point -> shapes.addAll(Solids.rod(point, hub, radius)));
    }
    if (!massShown) {
      shapes.add(mass(box, body));
    }
    return shapes;
  }

  /** Returns the spheres, discs and tyres by which a body is in contact. */
  private List<Mesh> balls(int body) {
    return scene.forces().stream()
        .filter(force -> force.kind() == SceneForce.Kind.CONTACT && force.radius() > 0)
        .filter(force -> force.anchors().get(0).body() == body)
        .map(Stage::round)
        .toList();
  }

  /** Returns the sphere of a contact, or its disc as a tyre. */
  private static Mesh round(SceneForce force) {
    double r = force.radius();
    Point3 centre = force.anchors().get(0).point();
    return force.isOfDisc()
        ? Solids.tube(0.6 * r, r, 0.35 * r).moved(Solids.zAlong(force.axle(), centre))
        : Solids.sphere(r).moved(at(centre));
  }

  /** Returns whether a box says more than the rod between two points. */
  private boolean bulky(InertiaBox box, List<Point3> points) {
    Point3 along = points.get(1).minus(points.get(0));
    double thickness = Math.max(box.size().x(), Math.max(box.size().y(), box.size().z()));
    double second = middle(box.size());
    return thickness > 0 && second > 0.15 * along.norm();
  }

  private static double middle(Point3 size) {
    double least = Math.min(size.x(), Math.min(size.y(), size.z()));
    double most = Math.max(size.x(), Math.max(size.y(), size.z()));
    return size.x() + size.y() + size.z() - least - most;
  }

  /** Returns a body's mass as a solid of its inertia, or as a ball if it has no inertia. */
  private Mesh mass(InertiaBox box, SceneBody body) {
    Point3 size = box.size();
    double longest = Math.max(size.x(), Math.max(size.y(), size.z()));
    if (longest <= 0.02 * extent) {
      return Solids.sphere(0.03 * extent).moved(at(body.centreOfMass()));
    }
    double scale = Math.min(1, LARGEST_BOX * extent / longest);
    double least = 0.02 * extent;
    double[] edges = {
      Math.max(least, scale * size.x()),
      Math.max(least, scale * size.y()),
      Math.max(least, scale * size.z())
    };
    return round(edges).orElseGet(() -> Solids.box(edges[0], edges[1], edges[2])).moved(box.pose());
  }

  /**
   * Returns the cylinder with the inertia of a box about its long or short axis, where two of the
   * edges are equal and the third is not: a wheel or a bar rather than a block.
   */
  private static Optional<Mesh> round(double[] edges) {
    for (int axis = 0; axis < 3; axis++) {
      double one = edges[(axis + 1) % 3];
      double other = edges[(axis + 2) % 3];
      boolean equal = Math.abs(one - other) < 0.02 * one;
      if (equal && Math.abs(edges[axis] - one) > 0.2 * one) {
        // m r²/2 = m (a² + a²)/12
        Mesh cylinder = Solids.cylinder(one / Math.sqrt(3), edges[axis]);
        Point3 along = new Point3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
        return Optional.of(cylinder.moved(Solids.zAlong(along, Point3.ZERO)));
      }
    }
    return Optional.empty();
  }

  private static Point3 middle(List<Point3> points) {
    Point3 sum = Point3.ZERO;
    for (Point3 point : points) {
      sum = sum.plus(point);
    }
    return sum.times(1.0 / Math.max(1, points.size()));
  }

  private static BodyPose at(Point3 point) {
    return new BodyPose(point, 1, 0, 0, 0);
  }

  /** Marks where the mechanism is held. */
  private void addFixedPoints() {
    double size = 0.035 * extent;
    for (SceneJoint joint : scene.joints()) {
      for (Anchor anchor : List.of(joint.first(), joint.second())) {
        if (anchor.body() == Anchor.ROOT && joint.type() != JointType.F) {
          Mesh block = Solids.box(size, size, size).moved(at(anchor.point()));
          add(Anchor.ROOT, Part.Role.BODY, scene.rootName(), block);
        }
      }
    }
  }

  private void addJoint(SceneJoint joint) {
    double r = 0.02 * extent;
    Anchor first = joint.first();
    BodyPose along =
        joint.axis().norm() > 0 ? Solids.zAlong(joint.axis(), first.point()) : at(first.point());
    switch (joint.type()) {
      case R -> addSymbol(joint, Solids.cylinder(r, 3.2 * r).moved(along));
      case P -> addSymbol(joint, Solids.box(2 * r, 2 * r, 4 * r).moved(along));
      case C, H -> addSymbol(joint, Solids.tube(0.6 * r, 1.1 * r, 4 * r).moved(along));
      case S -> addSymbol(joint, Solids.sphere(1.2 * r).moved(along));
      case PL -> addSymbol(joint, Solids.box(6 * r, 6 * r, 0.4 * r).moved(along));
      case W -> addSymbol(joint, Solids.box(1.6 * r, 1.6 * r, 1.6 * r).moved(along));
      case U -> {
        addSymbol(joint, Solids.cylinder(0.7 * r, 4 * r).moved(along));
        Anchor second = joint.second();
        Mesh cross = Solids.cylinder(0.7 * r, 4 * r);
        add(
            second.body(),
            Part.Role.JOINT,
            joint.name(),
            cross.moved(Solids.zAlong(joint.axis2(), second.point())));
      }
      case F -> {
        // nothing holds the body
      }
    }
  }

  private void addSymbol(SceneJoint joint, Mesh mesh) {
    add(joint.first().body(), Part.Role.JOINT, joint.name(), mesh);
  }

  private void addConstraint(SceneConstraint constraint) {
    switch (constraint.kind()) {
      case ROD, DISTANCE ->
          links.add(
              new Strut(
                  Strut.Kind.ROD,
                  constraint.name(),
                  constraint.anchors().get(0),
                  constraint.anchors().get(1)));
      case POINT_ON_LINE -> {
        Anchor line = constraint.anchors().get(1);
        BodyPose along = Solids.zAlong(constraint.direction(), line.point());
        Mesh rail = Solids.cylinder(0.006 * extent, 1.2 * extent).moved(along);
        add(line.body(), Part.Role.JOINT, constraint.name(), rail);
      }
      case ROLLING -> {
        Anchor plane = constraint.anchors().get(1);
        addSurface(constraint.name(), plane, constraint.direction());
        addWheel(constraint.name(), constraint.anchors().get(0), constraint.wheel().orElseThrow());
      }
      case KNIFE_EDGE -> {
        Anchor point = constraint.anchors().get(0);
        Point3 side = constraint.direction().times(0.05 * extent);
        Solids.rod(point.point().minus(side), point.point().plus(side), 0.006 * extent)
            .forEach(mesh -> add(point.body(), Part.Role.JOINT, constraint.name(), mesh));
      }
      case POINT_ON_PLANE -> {
        Anchor plane = constraint.anchors().get(1);
        addSurface(constraint.name(), plane, constraint.direction());
      }
      // a rope; another coupling relates coordinates and is at no place
      case COUPLING -> addRope(constraint.name(), constraint.anchors());
    }
  }

  private void addWheel(String name, Anchor centre, SceneConstraint.Wheel wheel) {
    double r = wheel.radius();
    Mesh mesh =
        wheel.isBall()
            ? Solids.sphere(r).moved(at(centre.point()))
            : Solids.tube(0.92 * r, r, 0.06 * r).moved(Solids.zAlong(wheel.axle(), centre.point()));
    add(centre.body(), Part.Role.JOINT, name, mesh);
  }

  private void addSurface(String name, Anchor at, Point3 normal) {
    if (surfaces.add(new Surface(at, normal))) {
      Mesh sheet =
          Solids.box(1.2 * extent, 1.2 * extent, 0.002 * extent)
              .moved(Solids.zAlong(normal, at.point()))
              .coloured(SURFACE, 0.35);
      parts.add(new Part(at.body(), Part.Role.SURFACE, name, sheet, SURFACE));
    }
  }

  private void addForce(SceneForce force) {
    switch (force.kind()) {
      case SPRING, SPRING_DAMPER -> addLink(Strut.Kind.SPRING, force);
      case DAMPER -> addLink(Strut.Kind.DAMPER, force);
      case ROPE -> addRope(force.name(), force.anchors());
      case CONTACT -> {
        if (force.direction().norm() > 0) {
          Anchor surface = force.anchors().get(1);
          Point3 normal = scene.pose(surface.body()).turnBack(force.direction());
          addSurface(force.name(), surface, normal);
        }
      }
      default -> {
        // drawn by its arrow, or in its joint
      }
    }
  }

  private void addRope(String name, List<Anchor> passed) {
    for (int i = 1; i < passed.size(); i++) {
      links.add(new Strut(Strut.Kind.ROD, name, passed.get(i - 1), passed.get(i)));
    }
  }

  private void addLink(Strut.Kind kind, SceneForce force) {
    links.add(new Strut(kind, force.name(), force.anchors().get(0), force.anchors().get(1)));
  }
}
