package org.mechservice.robot;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.robot.Robot.FileShape;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.OwnShape;
import org.mechservice.robot.Robot.Visual;
import org.mechservice.solver.spatial.Vector3;

/**
 * What the bodies of a robot look like. MechML gives a body one file, in its frame and in metres,
 * so all visuals of a link go into one glTF file with their poses, scales and colours. Where no
 * such files can be written a single mesh in the frame of its link keeps its name, and the others
 * are losses of the picture.
 */
final class RobotLooks {
  private static final List<Double> GREY = List.of(0.6, 0.6, 0.62, 1.0);

  private final Optional<String> folder;
  private final ImportLosses losses;
  private final Map<String, byte[]> files = new LinkedHashMap<>();
  private final Set<String> names = new HashSet<>();
  private final Map<Path, Optional<List<MeshFile.Part>>> read = new HashMap<>();

  /**
   * @param folder in which files of looks will lie, relative to the model; empty if none are
   *     written
   */
  RobotLooks(Optional<String> folder, ImportLosses losses) {
    this.folder = folder;
    this.losses = losses;
  }

  /** Returns the files by name, relative to the model. */
  Map<String, byte[]> files() {
    return files;
  }

  /** Returns the geometry file of a link, if it has one. */
  Optional<String> source(Link link) {
    if (link.visuals().isEmpty()) {
      return Optional.empty();
    }
    return folder.isEmpty() ? named(link) : written(link, folder.get());
  }

  private Optional<String> named(Link link) {
    Visual first = link.visuals().get(0);
    boolean plain =
        first.shape() instanceof FileShape mesh
            && mesh.scale().equals(new Vector3(1, 1, 1))
            && first.frame().at().equals(Vector3.ZERO)
            && first.frame().turn().isIdentity();
    int lost = link.visuals().size() - (plain ? 1 : 0);
    if (lost > 0) {
      losses.picture(
          first.element(),
          (lost == 1 ? "a visual is" : lost + " visuals are")
              + " left out: without a folder for their files, only one mesh in the frame of its"
              + " link is shown");
    }
    return plain && first.shape() instanceof FileShape mesh
        ? Optional.of(mesh.name())
        : Optional.empty();
  }

  private Optional<String> written(Link link, String inside) {
    Map<List<Double>, List<TriangleMesh>> byColour = new LinkedHashMap<>();
    for (Visual visual : link.visuals()) {
      for (MeshFile.Part part : parts(visual)) {
        byColour
            .computeIfAbsent(
                visual.colour().or(part::colour).orElse(GREY), key -> new ArrayList<>())
            .add(part.surface().in(visual.frame()));
      }
    }
    byColour.values().forEach(all -> all.removeIf(one -> one.faces().isEmpty()));
    byColour.values().removeIf(List::isEmpty);
    if (byColour.isEmpty()) {
      return Optional.empty();
    }
    String plain = link.name().replaceAll("[^A-Za-z0-9_-]", "_");
    String name = plain;
    for (int i = 2; !names.add(name.toLowerCase(Locale.ROOT)); i++) {
      name = plain + "_" + i;
    }
    String file = inside + "/" + name + ".glb";
    files.put(file, glb(byColour));
    return Optional.of(file);
  }

  private List<MeshFile.Part> parts(Visual visual) {
    if (visual.shape() instanceof OwnShape own) {
      return List.of(new MeshFile.Part(own.surface(), Optional.empty()));
    }
    FileShape shape = (FileShape) visual.shape();
    if (shape.file().isEmpty()) {
      losses.picture(
          visual.element(),
          Quoted.of(shape.name()) + " is left out: it does not exist; --path tells where to look");
      return List.of();
    }
    Path file = shape.file().get();
    Optional<List<MeshFile.Part>> parts = read.get(file);
    if (parts == null) {
      parts = read(visual, file);
      read.put(file, parts);
    }
    return parts.orElse(List.of()).stream()
        .map(part -> new MeshFile.Part(part.surface().scaled(shape.scale()), part.colour()))
        .toList();
  }

  private Optional<List<MeshFile.Part>> read(Visual visual, Path file) {
    try {
      return Optional.of(MeshFile.parts(file));
    } catch (IOException e) {
      losses.picture(
          visual.element(),
          Quoted.of(String.valueOf(file.getFileName())) + " is left out: " + e.getMessage());
      return Optional.empty();
    }
  }

  /** Returns a binary file of glTF 2.0 with one primitive for each colour. */
  private static byte[] glb(Map<List<Double>, List<TriangleMesh>> byColour) {
    List<String> primitives = new ArrayList<>();
    List<String> materials = new ArrayList<>();
    List<String> accessors = new ArrayList<>();
    List<String> views = new ArrayList<>();
    List<ByteBuffer> chunks = new ArrayList<>();
    int at = 0;
    for (Map.Entry<List<Double>, List<TriangleMesh>> one : byColour.entrySet()) {
      TriangleMesh whole = TriangleMesh.together(one.getValue());
      ByteBuffer points = little(12 * whole.points().size());
      double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
      double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
      for (Vector3 p : whole.points()) {
        double[] xyz = {p.x(), p.y(), p.z()};
        for (int i = 0; i < 3; i++) {
          points.putFloat((float) xyz[i]);
          low[i] = Math.min(low[i], (float) xyz[i]);
          high[i] = Math.max(high[i], (float) xyz[i]);
        }
      }
      ByteBuffer corners = little(12 * whole.faces().size());
      whole.faces().forEach(face -> corners.putInt(face[0]).putInt(face[1]).putInt(face[2]));
      int k = accessors.size();
      primitives.add(
          "{\"attributes\":{\"POSITION\":%d},\"indices\":%d,\"material\":%d}"
              .formatted(k, k + 1, materials.size()));
      materials.add(material(one.getKey()));
      accessors.add(
          "{\"bufferView\":%d,\"componentType\":5126,\"count\":%d,\"type\":\"VEC3\",\"min\":%s,\"max\":%s}"
              .formatted(k, whole.points().size(), list(low), list(high)));
      accessors.add(
          "{\"bufferView\":%d,\"componentType\":5125,\"count\":%d,\"type\":\"SCALAR\"}"
              .formatted(k + 1, 3 * whole.faces().size()));
      for (ByteBuffer chunk : List.of(points, corners)) {
        views.add(
            "{\"buffer\":0,\"byteOffset\":%d,\"byteLength\":%d}".formatted(at, chunk.capacity()));
        chunks.add(chunk);
        at += chunk.capacity();
      }
    }
    String json =
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
            + "\"meshes\":[{\"primitives\":["
            + String.join(",", primitives)
            + "]}],\"materials\":["
            + String.join(",", materials)
            + "],\"accessors\":["
            + String.join(",", accessors)
            + "],\"bufferViews\":["
            + String.join(",", views)
            + "],\"buffers\":[{\"byteLength\":"
            + at
            + "}]}";
    json += " ".repeat((4 - json.length() % 4) % 4);
    byte[] text = json.getBytes(StandardCharsets.UTF_8);
    byte[] all = new byte[12 + 8 + text.length + 8 + at];
    ByteBuffer file = ByteBuffer.wrap(all).order(ByteOrder.LITTLE_ENDIAN);
    file.putInt(0x46546c67).putInt(2).putInt(all.length);
    file.putInt(text.length).putInt(0x4e4f534a).put(text);
    file.putInt(at).putInt(0x004e4942);
    chunks.forEach(chunk -> file.put(chunk.flip()));
    return all;
  }

  private static ByteBuffer little(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static String list(double[] values) {
    return "[%s,%s,%s]".formatted(values[0], values[1], values[2]);
  }

  private static String material(List<Double> rgba) {
    String factor =
        "[%s,%s,%s,%s]"
            .formatted(light(rgba.get(0)), light(rgba.get(1)), light(rgba.get(2)), rgba.get(3));
    return "{\"pbrMetallicRoughness\":{\"baseColorFactor\":"
        + factor
        + ",\"metallicFactor\":0,\"roughnessFactor\":0.8},\"doubleSided\":true"
        + (rgba.get(3) < 1 ? ",\"alphaMode\":\"BLEND\"" : "")
        + "}";
  }

  /** Returns a part of what screens take, 0 to 1, as light (IEC 61966-2-1). */
  private static double light(double part) {
    double within = Math.max(0, Math.min(1, part));
    return within <= 0.04045 ? within / 12.92 : Math.pow((within + 0.055) / 1.055, 2.4);
  }
}
