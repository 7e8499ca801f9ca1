package org.mechservice.robot;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentReader;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads the surfaces of a COLLADA file (.dae), version 1.4 and 1.5: triangles and polygons of the
 * geometries in its scene, with the diffuse colours of their materials, in metres. Like the
 * programs of ROS it leaves out which axis the file calls upward.
 */
final class ColladaFile {
  private static final Pattern BLANKS = Pattern.compile("\\s+");

  private final Map<String, Element> byId = new HashMap<>();
  private final List<MeshFile.Part> parts = new ArrayList<>();

  private ColladaFile() {}

  /** An affine map: three rows of four numbers. */
  private static final class Affine {
    static final Affine SAME = new Affine(new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});

    private final double[] m;

    Affine(double[] m) {
      this.m = m;
    }

    Affine times(Affine inner) {
      double[] product = new double[12];
      for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
          for (int k = 0; k < 3; k++) {
            product[4 * i + j] += m[4 * i + k] * inner.m[4 * k + j];
          }
          product[4 * i + j] += j == 3 ? m[4 * i + 3] : 0;
        }
      }
      return new Affine(product);
    }

    Vector3 apply(double x, double y, double z) {
      return new Vector3(
          m[0] * x + m[1] * y + m[2] * z + m[3],
          m[4] * x + m[5] * y + m[6] * z + m[7],
          m[8] * x + m[9] * y + m[10] * z + m[11]);
    }
  }

  static List<MeshFile.Part> read(byte[] content) throws IOException {
    Element root;
    try {
      root = DocumentReader.readForeign(content, new Diagnostics("dae"));
    } catch (MechmlException e) {
      throw new IOException(
          "it is no COLLADA that can be read: " + e.diagnostics().get(0).message(), e);
    }
    ColladaFile file = new ColladaFile();
    file.collect(root);
    double unit =
        root.child("asset")
            .flatMap(asset -> asset.child("unit"))
            .flatMap(one -> one.attribute("meter"))
            .map(Double::parseDouble)
            .orElse(1.0);
    Affine metres = new Affine(new double[] {unit, 0, 0, 0, 0, unit, 0, 0, 0, 0, unit, 0});
    Optional<Element> scene =
        root.child("scene")
            .flatMap(one -> one.child("instance_visual_scene"))
            .flatMap(file::target);
    if (scene.isEmpty()) {
      throw new IOException("it has no scene");
    }
    for (Element node : scene.get().children("node")) {
      file.node(node, metres);
    }
    return file.parts;
  }

  private void collect(Element element) {
    element.attribute("id").ifPresent(id -> byId.put(id, element));
    element.children().forEach(this::collect);
  }

  private Optional<Element> target(Element reference) {
    return reference
        .attribute("url")
        .or(() -> reference.attribute("target"))
        .or(() -> reference.attribute("source"))
        .map(url -> url.replaceFirst("^#", ""))
        .flatMap(id -> Optional.ofNullable(byId.get(id)));
  }

  private void node(Element node, Affine above) throws IOException {
    Affine here = above;
    for (Element child : node.children()) {
      here = here.times(placed(child));
    }
    for (Element child : node.children()) {
      switch (child.name()) {
        case "node" -> node(child, here);
        case "instance_node" -> {
          Optional<Element> other = target(child);
          if (other.isPresent()) {
            node(other.get(), here);
          }
        }
        case "instance_geometry" -> {
          Optional<Element> mesh = target(child).flatMap(geometry -> geometry.child("mesh"));
          if (mesh.isPresent()) {
            mesh(mesh.get(), materials(child), here);
          }
        }
        default -> {
          // Cameras and lights are not shown.
        }
      }
    }
  }

  private static Affine placed(Element child) {
    return switch (child.name()) {
      case "matrix" -> {
        double[] all = numbers(child);
        double[] rows = new double[12];
        System.arraycopy(all, 0, rows, 0, 12);
        yield new Affine(rows);
      }
      case "translate" -> {
        double[] v = numbers(child);
        yield new Affine(new double[] {1, 0, 0, v[0], 0, 1, 0, v[1], 0, 0, 1, v[2]});
      }
      case "scale" -> {
        double[] v = numbers(child);
        yield new Affine(new double[] {v[0], 0, 0, 0, 0, v[1], 0, 0, 0, 0, v[2], 0});
      }
      case "rotate" -> {
        double[] v = numbers(child);
        Vector3 axis = new Vector3(v[0], v[1], v[2]);
        Rotation r =
            axis.norm() > 0
                ? Rotation.about(axis.normalized(), Math.toRadians(v[3]))
                : Rotation.IDENTITY;
        yield new Affine(
            new double[] {
              r.xx(), r.xy(), r.xz(), 0, r.yx(), r.yy(), r.yz(), 0, r.zx(), r.zy(), r.zz(), 0
            });
      }
      default -> Affine.SAME;
    };
  }

  /** Returns the colours of the materials that an instance binds, by symbol. */
  private Map<String, List<Double>> materials(Element instance) {
    Map<String, List<Double>> colours = new HashMap<>();
    descendants(instance, "instance_material")
        .forEach(
            one ->
                target(one)
                    .flatMap(material -> material.child("instance_effect"))
                    .flatMap(this::target)
                    .flatMap(ColladaFile::diffuse)
                    .ifPresent(rgba -> colours.put(one.attribute("symbol").orElse(""), rgba)));
    return colours;
  }

  private static Optional<List<Double>> diffuse(Element effect) {
    return descendants(effect, "diffuse").stream()
        .flatMap(one -> one.children("color").stream())
        .map(ColladaFile::numbers)
        .filter(c -> c.length == 4)
        .map(c -> List.of(c[0], c[1], c[2], c[3]))
        .findFirst();
  }

  private static List<Element> descendants(Element element, String name) {
    List<Element> all = new ArrayList<>();
    for (Element child : element.children()) {
      if (child.name().equals(name)) {
        all.add(child);
      }
      all.addAll(descendants(child, name));
    }
    return all;
  }

  private static double[] numbers(Element element) {
    String text = element.text().strip();
    String[] words = text.isEmpty() ? new String[0] : BLANKS.split(text, -1);
    double[] all = new double[words.length];
    for (int i = 0; i < words.length; i++) {
      all[i] = Double.parseDouble(words[i]);
    }
    return all;
  }

  private void mesh(Element mesh, Map<String, List<Double>> colours, Affine here)
      throws IOException {
    for (Element faces : mesh.children()) {
      if (!List.of("triangles", "polylist", "polygons").contains(faces.name())) {
        continue;
      }
      int step = 1;
      int offset = 0;
      Optional<Element> positions = Optional.empty();
      for (Element input : faces.children("input")) {
        int at = Integer.parseInt(input.attribute("offset").orElse("0"));
        step = Math.max(step, at + 1);
        if (input.attribute("semantic").filter("VERTEX"::equals).isPresent()) {
          offset = at;
          positions =
              target(input)
                  .flatMap(
                      vertices ->
                          vertices.children("input").stream()
                              .filter(
                                  one ->
                                      one.attribute("semantic")
                                          .filter("POSITION"::equals)
                                          .isPresent())
                              .findFirst())
                  .flatMap(this::target)
                  .flatMap(source -> source.child("float_array"));
        }
      }
      if (positions.isEmpty()) {
        throw new IOException("a surface has no positions");
      }
      double[] xyz = numbers(positions.get());
      List<Vector3> points = new ArrayList<>();
      for (int i = 0; i + 2 < xyz.length; i += 3) {
        points.add(here.apply(xyz[i], xyz[i + 1], xyz[i + 2]));
      }
      List<int[]> triangles = new ArrayList<>();
      Optional<double[]> counts = faces.child("vcount").map(ColladaFile::numbers);
      for (Element p : faces.children("p")) {
        double[] indices = numbers(p);
        int corners = indices.length / step;
        int from = 0;
        for (int k = 0; from < corners; k++) {
          int size =
              faces.name().equals("triangles")
                  ? 3
                  : counts.isPresent() ? (int) counts.get()[k] : corners;
          for (int i = 2; i < size; i++) {
            triangles.add(
                new int[] {
                  (int) indices[step * from + offset],
                  (int) indices[step * (from + i - 1) + offset],
                  (int) indices[step * (from + i) + offset]
                });
          }
          from += size;
        }
      }
      parts.add(
          new MeshFile.Part(
              new TriangleMesh(points, triangles),
              Optional.ofNullable(colours.get(faces.attribute("material").orElse("")))));
    }
  }
}
