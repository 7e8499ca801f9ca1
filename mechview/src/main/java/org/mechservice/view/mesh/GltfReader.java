package org.mechservice.view.mesh;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads glTF 2.0 (Khronos, 2021): the triangles of the nodes of its scene, with base colour and
 * opacity. Binary files (.glb) hold their numbers, text files (.gltf) have them in data URIs; other
 * buffers, which would be further files, are refused, as are extensions that a reader must know.
 */
final class GltfReader {
  private static final int MAGIC = 0x46546c67;
  private static final int JSON_CHUNK = 0x4e4f534a;
  private static final int BINARY_CHUNK = 0x004e4942;
  private static final String DATA = "data:";

  /** Nodes in nodes; a cycle of nodes has no end. */
  private static final int DEEPEST = 64;

  private static final int MOST_SURFACES = 10_000;
  private static final int MOST_NODES = 100_000;
  private static final int TRIANGLES = 4;
  private static final int FLOAT = 5126;

  /** Columns of the matrix that changes nothing. */
  private static final double[] UNMOVED = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  /**
   * Numbers of an accessor.
   *
   * @param bytes where they are
   * @param offset of the first, bytes
   * @param stride from one element to the next, bytes
   * @param count elements
   * @param type of a component, as glTF numbers them
   */
  private record Numbers(ByteBuffer bytes, int offset, int stride, int count, int type) {
    double coordinate(int element, int axis) {
      return bytes.getFloat(offset + stride * element + 4 * axis);
    }

    long index(int element) throws MeshException {
      int at = offset + stride * element;
      return switch (type) {
        case 5121 -> bytes.get(at) & 0xff;
        case 5123 -> bytes.getShort(at) & 0xffff;
        case 5125 -> Integer.toUnsignedLong(bytes.getInt(at));
        default -> throw new MeshException("its indices are of the type " + type);
      };
    }
  }

  private final JsonObject file;
  private final List<ByteBuffer> buffers = new ArrayList<>();
  private final List<Mesh> found = new ArrayList<>();
  private int nodes;
  private long triangles;

  private GltfReader(JsonObject file, Optional<ByteBuffer> binary) throws MeshException {
    this.file = file;
    JsonArray needed = array(file, "extensionsRequired");
    if (!needed.isEmpty()) {
      throw new MeshException(
          "it needs " + MeshNumbers.quoted(needed.get(0).getAsString()) + " of glTF");
    }
    for (JsonElement one : array(file, "buffers")) {
      buffers.add(buffer(one.getAsJsonObject(), binary));
    }
  }

  static List<Mesh> read(byte[] content) throws MeshException {
    try {
      ByteBuffer bytes = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
      boolean isBinary = content.length >= 20 && bytes.getInt(0) == MAGIC;
      return isBinary ? binary(bytes) : of(content, Optional.empty());
    } catch (JsonParseException
        | IllegalStateException
        | ClassCastException
        | UnsupportedOperationException
        | IllegalArgumentException
        | IndexOutOfBoundsException e) {
      throw new MeshException("it is no glTF 2.0: " + e.getMessage());
    }
  }

  private static List<Mesh> binary(ByteBuffer bytes) throws MeshException {
    Optional<byte[]> json = Optional.empty();
    Optional<ByteBuffer> binary = Optional.empty();
    int at = 12;
    while (at + 8 <= bytes.limit()) {
      int length = bytes.getInt(at);
      ByteBuffer chunk = bytes.slice(at + 8, length).order(ByteOrder.LITTLE_ENDIAN);
      if (bytes.getInt(at + 4) == JSON_CHUNK) {
        byte[] text = new byte[length];
        chunk.get(text);
        json = Optional.of(text);
      } else if (bytes.getInt(at + 4) == BINARY_CHUNK) {
        binary = Optional.of(chunk);
      }
      at += 8 + length;
    }
    if (json.isEmpty()) {
      throw new MeshException("it is no glTF 2.0: it has no JSON");
    }
    return of(json.get(), binary);
  }

  private static List<Mesh> of(byte[] json, Optional<ByteBuffer> binary) throws MeshException {
    JsonObject file =
        JsonParser.parseString(new String(json, StandardCharsets.UTF_8)).getAsJsonObject();
    GltfReader reader = new GltfReader(file, binary);
    JsonArray scenes = array(file, "scenes");
    if (scenes.isEmpty()) {
      throw new MeshException("it has no scene");
    }
    JsonObject scene = scenes.get(number(file, "scene", 0)).getAsJsonObject();
    for (JsonElement node : array(scene, "nodes")) {
      reader.node(node.getAsInt(), UNMOVED, 0);
    }
    return reader.found;
  }

  private static ByteBuffer buffer(JsonObject buffer, Optional<ByteBuffer> binary)
      throws MeshException {
    if (!buffer.has("uri")) {
      return binary.orElseThrow(() -> new MeshException("a buffer has neither bytes nor a place"));
    }
    String uri = buffer.get("uri").getAsString();
    int comma = uri.indexOf(',');
    if (!uri.startsWith(DATA) || !uri.substring(0, Math.max(0, comma)).endsWith(";base64")) {
      throw new MeshException("its numbers are in another file; save it as .glb");
    }
    byte[] bytes = Base64.getDecoder().decode(uri.substring(comma + 1));
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private void node(int index, double[] above, int depth) throws MeshException {
    if (depth == DEEPEST) {
      throw new MeshException("its nodes are more than " + DEEPEST + " deep in each other");
    }
    nodes++;
    if (nodes > MOST_NODES) {
      throw new MeshException("it has more than " + MOST_NODES + " nodes");
    }
    JsonObject node = element("nodes", index);
    double[] here = product(above, matrix(node));
    if (node.has("mesh")) {
      JsonObject mesh = element("meshes", node.get("mesh").getAsInt());
      for (JsonElement primitive : array(mesh, "primitives")) {
        found.add(surface(primitive.getAsJsonObject(), here));
        if (found.size() > MOST_SURFACES) {
          throw new MeshException("it has more than " + MOST_SURFACES + " surfaces");
        }
      }
    }
    for (JsonElement child : array(node, "children")) {
      node(child.getAsInt(), here, depth + 1);
    }
  }

  private Mesh surface(JsonObject primitive, double[] m) throws MeshException {
    if (number(primitive, "mode", TRIANGLES) != TRIANGLES) {
      throw new MeshException("it has points, lines or strips; triangles are shown");
    }
    JsonObject attributes = primitive.getAsJsonObject("attributes");
    if (attributes == null || !attributes.has("POSITION")) {
      throw new MeshException("a surface has no corners");
    }
    Numbers corners = numbers(attributes.get("POSITION").getAsInt(), "VEC3", 12);
    if (corners.type != FLOAT) {
      throw new MeshException("its corners are of the type " + corners.type);
    }
    Surface mesh = new Surface(corners, m);
    if (primitive.has("indices")) {
      Numbers indices = numbers(primitive.get("indices").getAsInt(), "SCALAR", 1);
      requireRoom(indices.count / 3);
      for (int i = 0; i + 2 < indices.count; i += 3) {
        mesh.triangle(indices.index(i), indices.index(i + 1), indices.index(i + 2));
      }
    } else {
      requireRoom(corners.count / 3);
      for (int i = 0; i + 2 < corners.count; i += 3) {
        mesh.triangle(i, i + 1, i + 2);
      }
    }
    return primitive.has("material")
        ? coloured(mesh.built(), element("materials", primitive.get("material").getAsInt()))
        : mesh.built();
  }

  /** Surfaces may share their numbers, so that a small file stands for any number of triangles. */
  private void requireRoom(int more) throws MeshException {
    triangles += more;
    if (triangles > MeshBuilder.MOST_TRIANGLES) {
      throw new MeshException(
          "it has more than "
              + MeshBuilder.MOST_TRIANGLES
              + " triangles, counting each surface that shares them");
    }
  }

  /** A surface with those corners of an accessor that its triangles have. */
  private static final class Surface {
    private final Numbers corners;
    private final double[] m;
    private final MeshBuilder mesh = new MeshBuilder();
    private final Map<Long, Integer> taken = new HashMap<>();

    Surface(Numbers corners, double[] m) {
      this.corners = corners;
      this.m = m;
    }

    void triangle(long a, long b, long c) throws MeshException {
      mesh.triangle(corner(a), corner(b), corner(c));
    }

    private int corner(long index) throws MeshException {
      Integer known = taken.get(index);
      if (known != null) {
        return known;
      }
      if (index >= corners.count) {
        throw new MeshException(
            "a face names corner " + index + ", and there are " + corners.count);
      }
      double x = corners.coordinate((int) index, 0);
      double y = corners.coordinate((int) index, 1);
      double z = corners.coordinate((int) index, 2);
      int added =
          mesh.corner(
              m[0] * x + m[4] * y + m[8] * z + m[12],
              m[1] * x + m[5] * y + m[9] * z + m[13],
              m[2] * x + m[6] * y + m[10] * z + m[14]);
      taken.put(index, added);
      return added;
    }

    Mesh built() {
      return mesh.mesh();
    }
  }

  private static Mesh coloured(Mesh mesh, JsonObject material) {
    JsonObject surface = material.getAsJsonObject("pbrMetallicRoughness");
    JsonArray factor = surface == null ? new JsonArray() : array(surface, "baseColorFactor");
    if (factor.size() != 4) {
      return mesh;
    }
    int rgb = 0;
    for (int i = 0; i < 3; i++) {
      rgb = rgb << 8 | display(factor.get(i).getAsDouble());
    }
    boolean blends =
        material.has("alphaMode") && material.get("alphaMode").getAsString().equals("BLEND");
    return mesh.coloured(rgb, blends ? Math.max(0, Math.min(1, factor.get(3).getAsDouble())) : 1);
  }

  /** Returns a part of light as screens take it, 0 to 255 (IEC 61966-2-1). */
  private static int display(double light) {
    double part = light <= 0.0031308 ? 12.92 * light : 1.055 * Math.pow(light, 1 / 2.4) - 0.055;
    return (int) Math.round(255 * Math.max(0, Math.min(1, part)));
  }

  private Numbers numbers(int accessor, String type, int least) throws MeshException {
    JsonObject given = element("accessors", accessor);
    if (given.has("sparse") || !given.has("bufferView")) {
      throw new MeshException("its numbers are sparse; save them in full");
    }
    if (!given.get("type").getAsString().equals(type)) {
      throw new MeshException("it has " + given.get("type") + " where " + type + " belongs");
    }
    JsonObject view = element("bufferViews", given.get("bufferView").getAsInt());
    ByteBuffer bytes = buffers.get(number(view, "buffer", 0));
    int component = given.get("componentType").getAsInt();
    int size = least == 1 ? (component == 5121 ? 1 : component == 5123 ? 2 : 4) : least;
    int stride = number(view, "byteStride", size);
    int count = given.get("count").getAsInt();
    long offset = (long) number(view, "byteOffset", 0) + number(given, "byteOffset", 0);
    if (offset < 0
        || count < 0
        || stride < size
        || (count > 0 && offset + (long) stride * (count - 1) + size > bytes.limit())) {
      throw new MeshException("an accessor lies outside its buffer");
    }
    return new Numbers(bytes, (int) offset, stride, count, component);
  }

  private static double[] matrix(JsonObject node) {
    if (node.has("matrix")) {
      return doubles(node, "matrix", UNMOVED);
    }
    double[] q = doubles(node, "rotation", new double[] {0, 0, 0, 1});
    double[] s = doubles(node, "scale", new double[] {1, 1, 1});
    double[] p = doubles(node, "translation", new double[] {0, 0, 0});
    double x = q[0];
    double y = q[1];
    double z = q[2];
    double w = q[3];
    return new double[] {
      s[0] * (1 - 2 * (y * y + z * z)),
      s[0] * 2 * (x * y + w * z),
      s[0] * 2 * (x * z - w * y),
      0,
      s[1] * 2 * (x * y - w * z),
      s[1] * (1 - 2 * (x * x + z * z)),
      s[1] * 2 * (y * z + w * x),
      0,
      s[2] * 2 * (x * z + w * y),
      s[2] * 2 * (y * z - w * x),
      s[2] * (1 - 2 * (x * x + y * y)),
      0,
      p[0],
      p[1],
      p[2],
      1
    };
  }

  private static double[] product(double[] a, double[] b) {
    double[] c = new double[16];
    for (int column = 0; column < 4; column++) {
      for (int row = 0; row < 4; row++) {
        for (int k = 0; k < 4; k++) {
          c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
        }
      }
    }
    return c;
  }

  private JsonObject element(String list, int index) throws MeshException {
    JsonArray all = array(file, list);
    if (index < 0 || index >= all.size()) {
      throw new MeshException("it names number " + index + " of " + all.size() + " " + list);
    }
    return all.get(index).getAsJsonObject();
  }

  private static JsonArray array(JsonObject object, String name) {
    return object.has(name) ? object.getAsJsonArray(name) : new JsonArray();
  }

  private static int number(JsonObject object, String name, int otherwise) {
    return object.has(name) ? object.get(name).getAsInt() : otherwise;
  }

  private static double[] doubles(JsonObject object, String name, double[] otherwise) {
    JsonArray given = array(object, name);
    if (given.isEmpty()) {
      return otherwise;
    }
    double[] numbers = new double[otherwise.length];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = given.get(i).getAsDouble();
    }
    return numbers;
  }
}
