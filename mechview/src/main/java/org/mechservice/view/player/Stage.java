package org.mechservice.view.player;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.mesh.Mesh;
import org.mechservice.view.mesh.MeshException;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.mesh.Solids;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBelt;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneConstraint;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneGear;
import org.mechservice.view.scene.SceneJoint;
import org.mechservice.view.scene.SceneLook;
import org.mechservice.view.scene.SceneRoad;
import org.mechservice.view.scene.SceneRope;
import org.mechservice.view.scene.SceneSolid;

/**
 * The shapes that show a mechanism: the surfaces of its bodies and joints, and the links between
 * points of bodies that rods and springs are drawn as.
 *
 * <p>A body without a geometry file and without looks is drawn as its solids, with rods to those of
 * its joints that are away from them. Without solids it is a skeleton: rods between its joints and
 * its centre of mass, which is a ball. Only a body that has no skeleton, since it turns about its
 * centre of mass or is free, is drawn as the box or cylinder of even density that has its inertia;
 * those of the other bodies are hidden unless viewers ask for them. A body in contact by a sphere,
 * a tyre or a box gets that. Sizes of symbols follow from the extent of the mechanism at the start.
 */
public final class Stage {
  private static final int[] PALETTE = {
    0x4c8bd6, 0xe39a3b, 0x5aa86b, 0xc9605e, 0x8f78c9, 0x3fa7ad, 0xb5884f, 0xd77fae
  };
  private static final int GROUND = 0x8a9099;
  private static final int JOINT = 0x59636e;
  private static final int SURFACE = 0x93a08f;
  private static final int RUBBER = 0x2c2f34;
  private static final int STEEL = 0xc3cad2;
  private static final int ASPHALT = 0x767d85;

  /** Longest edge of a box that a body's inertia is drawn as, in parts of the extent. */
  private static final double LARGEST_BOX = 0.5;

  /** Radius of a body's rods, in parts of the extent, and at most of its longest rod. */
  private static final double ROD = 0.011;

  private static final double STOUTEST_ROD = 0.07;

  /** Spokes of a wheel, by which its turning is seen. */
  private static final int SPOKES = 5;

  private final SceneDescription scene;
  private final MeshFolder folder;
  private final double extent;
  private final double heaviest;
  private final Shapes shapes = new Shapes();
  private final List<Part> parts = new ArrayList<>();
  private final List<Strut> links = new ArrayList<>();
  private final List<String> warnings = new ArrayList<>();
  private final Set<Surface> surfaces = new HashSet<>();
  private final Set<List<Object>> passed = new HashSet<>();

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
    heaviest = scene.bodies().stream().mapToDouble(SceneBody::mass).max().orElse(0);
    for (int body = 0; body < scene.bodies().size(); body++) {
      addBody(body);
    }
    if (!addGeometry(Anchor.ROOT, scene.rootGeometry())) {
      if (!addLooks(Anchor.ROOT, scene.rootLooks())) {
        addSolids(Anchor.ROOT, scene.rootSolids());
        addFixedPoints();
      }
    }
    scene.gears().forEach(this::addGear);
    scene.belts().forEach(this::addBelt);
    scene.ropes().forEach(this::addPassed);
    scene.joints().forEach(this::addJoint);
    scene.constraints().forEach(this::addConstraint);
    scene.forces().forEach(this::addForce);
  }

  /** Returns what could not be shown as the model asks for: one message each. */
  public List<String> warnings() {
    return List.copyOf(warnings);
  }

  /**
   * Returns the surfaces, roads as far as a motion goes along them.
   *
   * @param motion without frames, roads are drawn around the place of the start
   */
  List<Part> parts(Recording motion) {
    List<Part> all = new ArrayList<>(parts);
    for (SceneRoad road : scene.roads()) {
      Mesh strip = new RoadStrip(scene, road, extent).of(motion);
      Shape shape = Shape.of(strip, road.frame());
      all.add(
          new Part(road.body(), Part.Role.ROAD, road.name(), shape, ASPHALT, 1, Part.Finish.DULL));
    }
    return all;
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
    for (SceneForce force : scene.forces()) {
      largest = Math.max(largest, 4 * force.radius());
    }
    for (SceneBody body : scene.bodies()) {
      for (SceneSolid solid : body.solids()) {
        largest = Math.max(largest, BodySurfaces.size(solid));
      }
      for (SceneLook look : body.looks()) {
        for (SceneSolid solid : look.solids()) {
          largest = Math.max(largest, BodySurfaces.size(solid));
        }
      }
    }
    if (largest < 1e-9) {
      for (SceneBody body : scene.bodies()) {
        largest = Math.max(largest, InertiaBox.of(body).size().norm());
      }
    }
    return largest > 0 && Double.isFinite(largest) ? largest : 1;
  }

  private void addBody(int index) {
    SceneBody body = scene.bodies().get(index);
    InertiaBox box = InertiaBox.of(body);
    if (addGeometry(index, body.geometry())) {
      addInertia(index, box);
      return;
    }
    if (addLooks(index, body.looks())) {
      addInertia(index, box);
      return;
    }
    List<SceneSolid> plain =
        body.solids().stream()
            .filter(
                one ->
                    scene.gears().stream()
                        .noneMatch(gear -> gear.body() == index && isBlank(one, gear)))
            .toList();
    boolean solid = addSolids(index, plain);
    boolean round = addRounds(index);
    if (solid || plain.size() < body.solids().size()) {
      addRods(index, body);
    } else if (!addSkeleton(index, body, round)) {
      addBody(index, mass(box, body));
      return;
    }
    addInertia(index, box);
  }

  /** Adds the box of a body's inertia, which is hidden at first. */
  private void addInertia(int index, InertiaBox box) {
    if (box.size().norm() > 0) {
      int colour = colour(index);
      parts.add(
          new Part(
              index,
              Part.Role.INERTIA,
              scene.bodyName(index),
              solid(box),
              colour,
              0.35,
              Part.Finish.GLOSSY));
    }
  }

  /** Adds the surfaces of a geometry file; returns whether there are any. */
  private boolean addGeometry(int body, String file) {
    if (file.isEmpty()) {
      return false;
    }
    String name = scene.bodyName(body);
    try {
      folder.read(file).forEach(mesh -> addBody(body, Shape.of(mesh)));
      return true;
    } catch (MeshException e) {
      warnings.add("body " + name + " is drawn as a simple shape: " + e.getMessage());
      return false;
    }
  }

  /** Adds the looks of a body; returns whether there are any that can be shown. */
  private boolean addLooks(int body, List<SceneLook> looks) {
    String name = scene.bodyName(body);
    BodySurfaces surfacesOf = new BodySurfaces(folder, shapes, extent);
    boolean shown = false;
    for (SceneLook look : looks) {
      for (SceneSolid solid : look.solids()) {
        try {
          for (Shape shape : surfacesOf.of(solid)) {
            boolean own = shape.mesh().colour() != Mesh.NO_COLOUR;
            int colour = own ? shape.mesh().colour() : colour(body);
            parts.add(
                new Part(
                    body,
                    Part.Role.BODY,
                    name,
                    shape.moved(look.at()),
                    look.colour() == SceneLook.NO_COLOUR ? colour : look.colour(),
                    look.opacity() * shape.mesh().opacity(),
                    Part.Finish.GLOSSY));
          }
          shown = true;
        } catch (MeshException e) {
          warnings.add("a look of body " + name + " is not drawn: " + e.getMessage());
        }
      }
    }
    return shown;
  }

  /** Adds the solids of a body; returns whether there are any that can be shown. */
  private boolean addSolids(int body, List<SceneSolid> solids) {
    String name = scene.bodyName(body);
    BodySurfaces surfacesOf = new BodySurfaces(folder, shapes, extent);
    boolean shown = false;
    for (SceneSolid solid : solids) {
      try {
        surfacesOf.of(solid).forEach(shape -> addBody(body, shape));
        shown = true;
      } catch (MeshException e) {
        warnings.add("a solid of body " + name + " is not drawn: " + e.getMessage());
      }
    }
    return shown;
  }

  /**
   * Joins the points of a body that lie away from its solids to its centre of mass, and its solids
   * too if none of them is there.
   */
  private void addRods(int index, SceneBody body) {
    double away = 0.03 * extent;
    Point3 hub = body.centreOfMass();
    if (body.solids().size() > 1
        && body.solids().stream().allMatch(one -> BodySurfaces.distance(one, hub) > away)) {
      for (SceneSolid one : body.solids()) {
        shapes
            .rod(BodySurfaces.centre(one), hub, 0.6 * ROD * extent)
            .forEach(shape -> addBody(index, shape));
      }
    }
    for (Point3 point : points(index)) {
      if (body.solids().stream().allMatch(one -> BodySurfaces.distance(one, point) > away)) {
        shapes
            .rod(point, body.centreOfMass(), 0.6 * ROD * extent)
            .forEach(shape -> addBody(index, shape));
      }
    }
  }

  private void addBody(int body, Shape shape) {
    boolean own = shape.mesh().colour() != Mesh.NO_COLOUR;
    int colour = own ? shape.mesh().colour() : colour(body);
    add(body, Part.Role.BODY, scene.bodyName(body), shape, colour);
  }

  private void add(int body, Part.Role role, String name, Shape shape, int colour) {
    Part.Finish finish = colour == RUBBER ? Part.Finish.DULL : Part.Finish.GLOSSY;
    parts.add(new Part(body, role, name, shape, colour, shape.mesh().opacity(), finish));
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

  /**
   * Adds rods between the points of a body and its centre of mass; returns whether they show it.
   *
   * @param round whether it is drawn as a ball or wheel besides
   */
  private boolean addSkeleton(int index, SceneBody body, boolean round) {
    List<Point3> points = points(index);
    boolean massive = body.mass() > 0;
    Point3 hub = massive ? body.centreOfMass() : middle(points);
    double longest = points.stream().mapToDouble(p -> p.minus(hub).norm()).max().orElse(0);
    if (longest < 0.015 * extent) {
      return round || (!massive && !points.isEmpty());
    }
    double radius = Math.min(ROD * extent, STOUTEST_ROD * 2 * longest);
    boolean straight = points.size() == 2 && isBetween(hub, points.get(0), points.get(1));
    if (straight) {
      shapes.capsule(points.get(0), points.get(1), radius).forEach(shape -> addBody(index, shape));
    } else {
      for (Point3 point : points) {
        shapes.capsule(point, hub, radius).forEach(shape -> addBody(index, shape));
      }
    }
    if (massive && !round) {
      addBody(
          index, shapes.ball(hub, Math.max(1.5 * radius, Math.min(ball(body), 0.35 * longest))));
    }
    return true;
  }

  /** Returns whether a point lies near the straight line between two others. */
  private static boolean isBetween(Point3 point, Point3 from, Point3 to) {
    Point3 along = to.minus(from);
    double share = point.minus(from).dot(along) / along.dot(along);
    return share > -0.05
        && share < 1.05
        && point.minus(from.plus(along.times(share))).norm() < 0.06 * along.norm();
  }

  /** Returns the radius of the ball that shows a body's mass, m. */
  private double ball(SceneBody body) {
    return (0.014 + 0.022 * Math.cbrt(body.mass() / heaviest)) * extent;
  }

  /**
   * Adds the spheres, discs, tyres and boxes by which a body is in contact; returns whether it has
   * any.
   */
  private boolean addRounds(int body) {
    boolean any = false;
    Set<List<Object>> known = new HashSet<>();
    for (SceneForce force : scene.forces()) {
      if (force.kind() == SceneForce.Kind.CONTACT
          && (force.radius() > 0 || force.box().isPresent())
          && force.anchors().get(0).body() == body) {
        any = true;
        Point3 centre = force.anchors().get(0).point();
        if (!known.add(List.of(centre, force.radius(), force.axle(), force.box()))) {
          continue;
        }
        if (force.box().isPresent()) {
          SceneForce.Box box = force.box().get();
          addBody(body, shapes.block(box.at(), box.edges()));
        } else if (force.isOfDisc()) {
          addTyre(body, Solids.zAlong(force.axle(), centre), force.radius());
        } else {
          addBody(body, shapes.ball(centre, force.radius()));
        }
      }
    }
    return any
        || scene.gears().stream()
            .anyMatch(gear -> gear.body() == body && gear.kind() != SceneGear.Kind.RING)
        || scene.constraints().stream()
            .anyMatch(one -> one.wheel().isPresent() && one.anchors().get(0).body() == body);
  }

  /** Adds a gear wheel or a pulley, as wide as the solid that it takes the place of. */
  private void addGear(SceneGear gear) {
    double width = gearWidth();
    String name = scene.bodyName(gear.body());
    if (gear.body() != Anchor.ROOT) {
      for (SceneSolid solid : scene.bodies().get(gear.body()).solids()) {
        if (isBlank(solid, gear) && solid instanceof SceneSolid.Round round) {
          width = round.to().minus(round.from()).norm();
        }
      }
    }
    Point3 x = gear.tooth();
    Point3 z = gear.axis();
    Point3 y = z.cross(x);
    double[] rows = {x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z()};
    BodyPose at = BodyPose.of(gear.centre(), rows, 0);
    switch (gear.kind()) {
      case WHEEL -> addBody(gear.body(), shapes.gear(at, gear.radius(), width, gear.teeth()));
      case RING ->
          add(
              gear.body(),
              Part.Role.BODY,
              name,
              shapes.ring(at, gear.radius(), width, gear.teeth()),
              STEEL);
      case PULLEY -> addBody(gear.body(), shapes.pulley(at, gear.radius(), width));
    }
  }

  private double gearWidth() {
    return 0.5 * scene.gears().stream().mapToDouble(SceneGear::radius).min().orElse(0);
  }

  /** Returns whether a solid is what a gear wheel was cut from. */
  private static boolean isBlank(SceneSolid solid, SceneGear gear) {
    if (!(solid instanceof SceneSolid.Round round)) {
      return false;
    }
    Point3 along = round.to().minus(round.from());
    Point3 aside = BodySurfaces.centre(solid).minus(gear.centre());
    return along.cross(gear.axis()).norm() < 1e-6 * along.norm()
        && aside.cross(gear.axis()).norm() < 0.01 * gear.radius()
        && Math.abs(round.radius() - gear.radius()) < 0.25 * gear.radius();
  }

  private void addBelt(SceneBelt belt) {
    double width = 0.55 * gearWidth();
    double thickness = 0.06 * Math.min(belt.first(), belt.second());
    Mesh band = Solids.belt(belt.first(), belt.second(), belt.distance(), width, thickness);
    add(
        belt.body(),
        Part.Role.BODY,
        scene.bodyName(belt.body()),
        Shape.of(band, belt.at()),
        RUBBER);
  }

  /** Adds the pulleys, spheres and cylinders that a rope passes. */
  private void addPassed(SceneRope rope) {
    for (SceneRope.Stop stop : rope.stops()) {
      if (stop instanceof SceneRope.Pulley pulley) {
        int body = pulley.centre().body();
        Point3 normal =
            scene.pose(rope.plane().body()).turn(rope.plane().axes().turn(new Point3(0, 0, 1)));
        BodyPose at = Solids.zAlong(scene.pose(body).turnBack(normal), pulley.centre().point());
        double r = pulley.radius();
        add(body, Part.Role.BODY, rope.name(), shapes.pulley(at, r, 0.4 * r), STEEL);
      } else if (stop instanceof SceneRope.Around around) {
        addAround(rope.name(), around);
      }
    }
  }

  /** Adds a shape that a rope goes around, as glass; several ropes may go around it. */
  private void addAround(String rope, SceneRope.Around around) {
    Anchor centre = around.centre();
    if (!passed.add(List.of(centre, around.axis(), around.radius()))) {
      return;
    }
    double r = around.radius();
    boolean ball = around.axis().norm() == 0;
    BodyPose at = ball ? Shapes.at(centre.point()) : Solids.zAlong(around.axis(), centre.point());
    Shape shape =
        ball
            ? shapes.ball(centre.point(), r)
            : around.inside()
                ? shapes.tube(at, r, 1.2 * r, 0.6 * r)
                : shapes.cylinder(at, r, 2.4 * r);
    parts.add(
        new Part(centre.body(), Part.Role.JOINT, rope, shape, STEEL, 0.5, Part.Finish.GLOSSY));
  }

  private void addTyre(int body, BodyPose at, double r) {
    String name = scene.bodyName(body);
    add(body, Part.Role.BODY, name, shapes.tyre(at, r, 0.42 * r), RUBBER);
    add(body, Part.Role.BODY, name, shapes.tube(at, 0.58 * r, 0.66 * r, 0.34 * r), STEEL);
    addSpokes(body, at, 0.6 * r, 0.035 * r);
  }

  private void addSpokes(int body, BodyPose at, double radius, double thickness) {
    addBody(body, shapes.cylinder(at, 0.2 * radius, 8 * thickness));
    for (int i = 0; i < SPOKES; i++) {
      double angle = 2 * Math.PI * i / SPOKES;
      Point3 out = at.toWorld(new Point3(radius * Math.cos(angle), radius * Math.sin(angle), 0));
      shapes.rod(at.position(), out, thickness).forEach(shape -> addBody(body, shape));
    }
  }

  /** Returns a body's mass as a solid of its inertia, or as a ball if it has no inertia. */
  private Shape mass(InertiaBox box, SceneBody body) {
    Point3 size = box.size();
    double longest = Math.max(size.x(), Math.max(size.y(), size.z()));
    return longest <= 0.02 * extent
        ? shapes.ball(body.centreOfMass(), body.mass() > 0 ? ball(body) : 0.01 * extent)
        : solid(box);
  }

  /**
   * Returns a box, not larger than the mechanism and not too thin to be seen, or the cylinder with
   * its inertia where two of its edges are equal and the third is not: a wheel or a bar rather than
   * a block.
   */
  private Shape solid(InertiaBox box) {
    Point3 size = box.size();
    double longest = Math.max(size.x(), Math.max(size.y(), size.z()));
    double scale = Math.min(1, LARGEST_BOX * extent / longest);
    double least = 0.02 * extent;
    double[] edges = {
      Math.max(least, scale * size.x()),
      Math.max(least, scale * size.y()),
      Math.max(least, scale * size.z())
    };
    for (int axis = 0; axis < 3; axis++) {
      double one = edges[(axis + 1) % 3];
      double other = edges[(axis + 2) % 3];
      boolean equal = Math.abs(one - other) < 0.02 * one;
      if (equal && Math.abs(edges[axis] - one) > 0.2 * one) {
        // m r²/2 = m (a² + a²)/12
        Point3 along = new Point3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
        BodyPose about = box.pose().times(Solids.zAlong(along, Point3.ZERO));
        return shapes.cylinder(about, one / Math.sqrt(3), edges[axis]);
      }
    }
    return shapes.block(box.pose(), new Point3(edges[0], edges[1], edges[2]));
  }

  private static Point3 middle(List<Point3> points) {
    Point3 sum = Point3.ZERO;
    for (Point3 point : points) {
      sum = sum.plus(point);
    }
    return sum.times(1.0 / Math.max(1, points.size()));
  }

  /** Marks where the mechanism is held. */
  private void addFixedPoints() {
    double size = 0.035 * extent;
    for (SceneJoint joint : scene.joints()) {
      for (Anchor anchor : List.of(joint.first(), joint.second())) {
        if (anchor.body() == Anchor.ROOT && !isOpen(joint) && joint.type() != JointType.P) {
          addBody(
              Anchor.ROOT, shapes.block(Shapes.at(anchor.point()), new Point3(size, size, size)));
        }
      }
    }
  }

  /** Returns whether nothing of a joint is seen: it leaves a body free, or in the plane at rest. */
  private static boolean isOpen(SceneJoint joint) {
    return joint.type() == JointType.F
        || (joint.type() == JointType.PL && joint.first().body() == Anchor.ROOT);
  }

  private void addJoint(SceneJoint joint) {
    if (isOpen(joint)) {
      return;
    }
    double r = symbolSize(joint);
    Anchor first = joint.first();
    BodyPose along =
        joint.axis().norm() > 0
            ? Solids.zAlong(joint.axis(), first.point())
            : Shapes.at(first.point());
    switch (joint.type()) {
      case R -> addSymbol(joint, shapes.cylinder(along, r, 3.2 * r));
      case P -> {
        // a block that slides with its body, on a guide from where it is at zero
        BodyPose turned = scene.pose(joint.second().body());
        Point3 axis = turned.turnBack(scene.pose(first.body()).turn(joint.axis()));
        Shape block =
            shapes.block(
                Solids.zAlong(axis, joint.second().point()), new Point3(2 * r, 2 * r, 4 * r));
        add(joint.second().body(), Part.Role.JOINT, joint.name(), block, JOINT);
        links.add(new Strut(Strut.Kind.GUIDE, joint.name(), first, joint.second()));
      }
      case C, H -> addSymbol(joint, shapes.tube(along, 0.6 * r, 1.1 * r, 4 * r));
      case S -> addSymbol(joint, shapes.ball(first.point(), 1.2 * r));
      case PL -> addSymbol(joint, shapes.block(along, new Point3(6 * r, 6 * r, 0.4 * r)));
      case W -> addSymbol(joint, shapes.block(along, new Point3(1.6 * r, 1.6 * r, 1.6 * r)));
      case U -> {
        addSymbol(joint, shapes.cylinder(along, 0.7 * r, 4 * r));
        Anchor second = joint.second();
        BodyPose other = Solids.zAlong(joint.axis2(), second.point());
        add(
            second.body(),
            Part.Role.JOINT,
            joint.name(),
            shapes.cylinder(other, 0.7 * r, 4 * r),
            JOINT);
      }
      case F -> {
        // nothing holds the body
      }
    }
  }

  /** Returns the size of a joint's symbol, m: less than of the wheel that it is in. */
  private double symbolSize(SceneJoint joint) {
    double size = 0.016 * extent;
    for (SceneForce force : scene.forces()) {
      if (force.isOfDisc()) {
        Point3 centre = scene.world(force.anchors().get(0));
        if (scene.world(joint.second()).minus(centre).norm() < force.radius()) {
          size = Math.min(size, 0.12 * force.radius());
        }
      }
    }
    return size;
  }

  private void addSymbol(SceneJoint joint, Shape shape) {
    add(joint.first().body(), Part.Role.JOINT, joint.name(), shape, JOINT);
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
        Shape rail = shapes.cylinder(along, 0.006 * extent, 1.2 * extent);
        add(line.body(), Part.Role.JOINT, constraint.name(), rail, JOINT);
      }
      case ROLLING -> {
        Anchor plane = constraint.anchors().get(1);
        addSurface(constraint.name(), plane, constraint.direction());
        addWheel(constraint.name(), constraint.anchors().get(0), constraint.wheel().orElseThrow());
      }
      case KNIFE_EDGE -> {
        Anchor point = constraint.anchors().get(0);
        Point3 side = constraint.direction().times(0.05 * extent);
        shapes
            .rod(point.point().minus(side), point.point().plus(side), 0.006 * extent)
            .forEach(one -> add(point.body(), Part.Role.JOINT, constraint.name(), one, JOINT));
      }
      case POINT_ON_PLANE -> {
        Anchor plane = constraint.anchors().get(1);
        addSurface(constraint.name(), plane, constraint.direction());
      }
      case COUPLING -> {
        // a rope is drawn by its way; another coupling relates coordinates and is at no place
      }
    }
  }

  private void addWheel(String name, Anchor centre, SceneConstraint.Wheel wheel) {
    double r = wheel.radius();
    int body = centre.body();
    if (wheel.isBall()) {
      addBody(body, shapes.ball(centre.point(), r));
      return;
    }
    BodyPose at = Solids.zAlong(wheel.axle(), centre.point());
    add(body, Part.Role.BODY, name, shapes.tube(at, 0.9 * r, r, 0.07 * r), RUBBER);
    add(body, Part.Role.BODY, name, shapes.tube(at, 0.86 * r, 0.92 * r, 0.06 * r), STEEL);
    addSpokes(body, at, 0.88 * r, 0.012 * r);
  }

  private void addSurface(String name, Anchor at, Point3 normal) {
    if (surfaces.add(new Surface(at, normal))) {
      Shape sheet =
          shapes.block(
              Solids.zAlong(normal, at.point()),
              new Point3(1.2 * extent, 1.2 * extent, 0.002 * extent));
      parts.add(
          new Part(at.body(), Part.Role.SURFACE, name, sheet, SURFACE, 0.35, Part.Finish.DULL));
    }
  }

  private void addForce(SceneForce force) {
    switch (force.kind()) {
      case SPRING -> addLink(Strut.Kind.SPRING, force);
      case SPRING_DAMPER -> {
        addLink(Strut.Kind.SPRING, force);
        addLink(Strut.Kind.DAMPER, force);
      }
      case DAMPER -> addLink(Strut.Kind.DAMPER, force);
      case CONTACT -> {
        boolean onRoad =
            scene.roads().stream()
                .anyMatch(road -> road.runners().contains(force.anchors().get(0)));
        if (force.direction().norm() > 0 && !onRoad) {
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

  private void addLink(Strut.Kind kind, SceneForce force) {
    links.add(new Strut(kind, force.name(), force.anchors().get(0), force.anchors().get(1)));
  }
}
