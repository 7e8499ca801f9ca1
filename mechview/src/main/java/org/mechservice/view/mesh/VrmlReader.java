package org.mechservice.view.mesh;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;

/**
 * Reads the surfaces of VRML 97: {@code IndexedFaceSet}, {@code Box}, {@code Cylinder}, {@code
 * Sphere} and {@code Cone} in {@code Shape}s, below {@code Group}, {@code Transform} and their
 * like. Of the appearance, diffuse colour and transparency are kept. Other geometry is refused by
 * name; lights, views, sounds and sensors are left out.
 */
final class VrmlReader {
  private static final int MOST_VISITS = 100_000;
  private static final Set<String> GROUPS =
      Set.of("Group", "Anchor", "Collision", "Billboard", "Transform");
  private static final Set<String> INVISIBLE = Set.of("IndexedLineSet", "PointSet", "Text");

  private final List<Mesh> surfaces = new ArrayList<>();
  private int visits;
  private int triangles;

  /**
   * Reads a file.
   *
   * @return surfaces in the file's axes, m; at least one
   */
  List<Mesh> read(byte[] content) throws MeshException {
    for (VrmlNode node : new VrmlParser(content).file()) {
      visit(node, Placement.NONE);
    }
    if (surfaces.isEmpty()) {
      throw new MeshException("it shows no surface");
    }
    return List.copyOf(surfaces);
  }

  private void visit(VrmlNode node, Placement placement) throws MeshException {
    visits++;
    if (visits > MOST_VISITS) {
      throw new MeshException("it has more than " + MOST_VISITS + " nodes, counting each USE");
    }
    if (node.type.equals("Shape")) {
      shape(node, placement);
    } else if (GROUPS.contains(node.type)) {
      Placement inner = node.type.equals("Transform") ? placement.inside(node) : placement;
      for (VrmlNode child : node.nodes("children")) {
        visit(child, inner);
      }
    } else if (node.type.equals("LOD")) {
      for (VrmlNode finest : node.nodes("level").stream().limit(1).toList()) {
        visit(finest, placement);
      }
    } else if (node.type.equals("Inline")) {
      throw new MeshException("Inline names another file, which is not read; save all in one file");
    }
  }

  private void shape(VrmlNode shape, Placement placement) throws MeshException {
    for (VrmlNode geometry : shape.nodes("geometry")) {
      if (!INVISIBLE.contains(geometry.type)) {
        Mesh mesh = painted(placement.of(surface(geometry)), shape);
        triangles += mesh.triangleCount();
        if (triangles > MeshBuilder.MOST_TRIANGLES) {
          throw new MeshException(
              "it has more than " + MeshBuilder.MOST_TRIANGLES + " triangles, counting each USE");
        }
        surfaces.add(mesh);
      }
    }
  }

  private static Mesh painted(Mesh mesh, VrmlNode shape) throws MeshException {
    for (VrmlNode appearance : shape.nodes("appearance")) {
      for (VrmlNode material : appearance.nodes("material")) {
        double[] colour = material.numbers("diffuseColor", 0.8, 0.8, 0.8);
        double clear = material.numbers("transparency", 0.0)[0];
        int rgb = channel(colour[0]) << 16 | channel(colour[1]) << 8 | channel(colour[2]);
        return mesh.coloured(rgb, 1 - Math.min(Math.max(clear, 0), 1));
      }
    }
    return mesh;
  }

  private static int channel(double share) {
    return (int) Math.round(255 * Math.min(Math.max(share, 0), 1));
  }

  private static Mesh surface(VrmlNode geometry) throws MeshException {
    switch (geometry.type) {
      case "Box" -> {
        double[] size = geometry.numbers("size", 2, 2, 2);
        return Solids.box(size[0], size[1], size[2]);
      }
      case "Sphere" -> {
        return Solids.sphere(geometry.numbers("radius", 1.0)[0]);
      }
      case "Cylinder" -> {
        return alongY(
            Solids.cylinder(
                geometry.numbers("radius", 1.0)[0], geometry.numbers("height", 2.0)[0]));
      }
      case "Cone" -> {
        return alongY(
            Solids.cone(
                geometry.numbers("bottomRadius", 1.0)[0], geometry.numbers("height", 2.0)[0]));
      }
      case "IndexedFaceSet" -> {
        return faces(geometry);
      }
      default ->
          throw new MeshException(
              "geometry "
                  + MeshNumbers.quoted(geometry.type)
                  + " is not supported; save it as IndexedFaceSet");
    }
  }

  private static Mesh alongY(Mesh alongZ) {
    return alongZ.moved(Solids.zAlong(new Point3(0, 1, 0), Point3.ZERO));
  }

  private static Mesh faces(VrmlNode set) throws MeshException {
    MeshBuilder mesh = new MeshBuilder();
    for (VrmlNode coordinates : set.nodes("coord")) {
      double[] points = coordinates.numbers("point");
      for (int i = 0; i + 2 < points.length; i += 3) {
        mesh.corner(points[i], points[i + 1], points[i + 2]);
      }
    }
    double[] indices = set.numbers("coordIndex");
    long[] around = new long[indices.length];
    int count = 0;
    for (double index : indices) {
      if (index < 0) {
        mesh.polygon(around, count);
        count = 0;
      } else {
        around[count] = (long) index;
        count++;
      }
    }
    mesh.polygon(around, count);
    return mesh.mesh();
  }

  /** The placement of the nodes below some Transforms: x ↦ M x + d. */
  private record Placement(Point3 x, Point3 y, Point3 z, Point3 d) {
    static final Placement NONE =
        new Placement(new Point3(1, 0, 0), new Point3(0, 1, 0), new Point3(0, 0, 1), Point3.ZERO);

    private Point3 turned(Point3 p) {
      return x.times(p.x()).plus(y.times(p.y())).plus(z.times(p.z()));
    }

    /** Returns the placement below a Transform: T · C · R · S · C⁻¹ (VRML 97, 6.52). */
    Placement inside(VrmlNode transform) throws MeshException {
      double[] t = transform.numbers("translation", 0, 0, 0);
      double[] c = transform.numbers("center", 0, 0, 0);
      double[] s = transform.numbers("scale", 1, 1, 1);
      BodyPose turn = rotation(transform.numbers("rotation", 0, 0, 1, 0));
      Point3 center = new Point3(c[0], c[1], c[2]);
      Point3 sx = turn.turn(new Point3(s[0], 0, 0));
      Point3 sy = turn.turn(new Point3(0, s[1], 0));
      Point3 sz = turn.turn(new Point3(0, 0, s[2]));
      Point3 scaledCenter = sx.times(c[0]).plus(sy.times(c[1])).plus(sz.times(c[2]));
      Point3 inner = new Point3(t[0], t[1], t[2]).plus(center).minus(scaledCenter);
      return new Placement(turned(sx), turned(sy), turned(sz), turned(inner).plus(d));
    }

    private static BodyPose rotation(double[] axisAngle) {
      Point3 axis = new Point3(axisAngle[0], axisAngle[1], axisAngle[2]);
      double length = axis.norm();
      if (!(length > 0)) {
        return BodyPose.WORLD;
      }
      Point3 half = axis.times(Math.sin(axisAngle[3] / 2) / length);
      return new BodyPose(Point3.ZERO, Math.cos(axisAngle[3] / 2), half.x(), half.y(), half.z());
    }

    Mesh of(Mesh mesh) throws MeshException {
      MeshBuilder placed = new MeshBuilder();
      float[] corners = mesh.corners();
      for (int i = 0; i < corners.length; i += 3) {
        Point3 p = turned(new Point3(corners[i], corners[i + 1], corners[i + 2])).plus(d);
        placed.corner(p.x(), p.y(), p.z());
      }
      int[] triangles = mesh.triangles();
      for (int i = 0; i < triangles.length; i += 3) {
        placed.triangle(triangles[i], triangles[i + 1], triangles[i + 2]);
      }
      return placed.mesh();
    }
  }
}
