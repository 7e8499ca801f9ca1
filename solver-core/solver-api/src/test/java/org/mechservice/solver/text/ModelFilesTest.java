package org.mechservice.solver.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What files hold that a model names, written into its text. */
class ModelFilesTest {
  @TempDir private Path folder = Path.of("");

  private String inlined(String model) throws IOException {
    byte[] read =
        ModelFiles.inlined(model.getBytes(StandardCharsets.UTF_8), folder.resolve("model.xml"));
    return new String(read, StandardCharsets.UTF_8);
  }

  private void write(String name, String text) throws IOException {
    Files.createDirectories(folder.resolve(name).toAbsolutePath().getParent());
    Files.writeString(folder.resolve(name), text);
  }

  private double[] numbers(String attribute, List<double[][]> triangles) throws IOException {
    write("part.stl", text(triangles));
    String mesh = inlined("<MechML><mesh file='part.stl'/></MechML>");
    String value = ModelFiles.attribute(mesh, attribute).orElseThrow();
    return Arrays.stream(value.split(";")).mapToDouble(Double::parseDouble).toArray();
  }

  private static String text(List<double[][]> triangles) {
    StringBuilder text = new StringBuilder("solid part\n");
    for (double[][] triangle : triangles) {
      text.append("facet normal 0 0 0\nouter loop\n");
      for (double[] c : triangle) {
        text.append(String.format(Locale.ROOT, "vertex %.17g %.17g %.17g%n", c[0], c[1], c[2]));
      }
      text.append("endloop\nendfacet\n");
    }
    return text + "endsolid part\n";
  }

  private static List<double[][]> box(double a, double b, double c, double[] at) {
    double[][] corners = new double[8][];
    for (int i = 0; i < 8; i++) {
      corners[i] =
          new double[] {at[0] + (i >> 2) * a, at[1] + (i >> 1 & 1) * b, at[2] + (i & 1) * c};
    }
    int[][] faces = {
      {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}
    };
    List<double[][]> triangles = new ArrayList<>();
    for (int[] f : faces) {
      triangles.add(new double[][] {corners[f[0]], corners[f[1]], corners[f[2]]});
      triangles.add(new double[][] {corners[f[0]], corners[f[2]], corners[f[3]]});
    }
    return triangles;
  }

  /** A sphere of radius 1 about (3, 0, 0), divided n times along half a circle. */
  private static List<double[][]> sphere(int n) {
    List<double[][]> triangles = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < 2 * n; j++) {
        double[] a = onSphere(i, j, n);
        double[] b = onSphere(i + 1, j, n);
        double[] c = onSphere(i + 1, j + 1, n);
        double[] d = onSphere(i, j + 1, n);
        triangles.add(new double[][] {a, b, c});
        triangles.add(new double[][] {a, c, d});
      }
    }
    return triangles;
  }

  /** Poles and the seam are the same to the bit from every side. */
  private static double[] onSphere(int i, int j, int n) {
    double polar = Math.PI * i / n;
    double around = Math.PI * (j % (2 * n)) / n;
    double r = i == 0 || i == n ? 0 : Math.sin(polar);
    return new double[] {3 + r * Math.cos(around), r * Math.sin(around), Math.cos(polar)};
  }

  /** Rounding of two dozen sums. */
  @Test
  void blockHasTheMomentsOfTheHandbookWhereverItLies() throws IOException {
    List<double[][]> block = box(0.5, 0.3, 0.2, new double[] {10, -4, 0.7});
    double v = 0.5 * 0.3 * 0.2;
    assertThat(numbers("volume", block)).containsExactly(new double[] {v}, within(1e-14));
    assertThat(numbers("center", block))
        .containsExactly(new double[] {10.25, -3.85, 0.8}, within(1e-13));
    assertThat(numbers("moments", block))
        .containsExactly(
            new double[] {
              v * (0.09 + 0.04) / 12, v * (0.25 + 0.04) / 12, v * (0.25 + 0.09) / 12, 0, 0, 0
            },
            within(1e-15));
  }

  /** Inside out, the surface encloses the same; so do two surfaces in one file. */
  @Test
  void orientationOfTheWholeSurfaceDoesNotMatter() throws IOException {
    List<double[][]> inward = new ArrayList<>();
    for (double[][] t : box(1, 2, 3, new double[3])) {
      inward.add(new double[][] {t[0], t[2], t[1]});
    }
    assertThat(numbers("volume", inward)).containsExactly(new double[] {6}, within(1e-14));
    List<double[][]> two = new ArrayList<>(box(1, 1, 1, new double[3]));
    two.addAll(box(1, 1, 1, new double[] {2, 0, 0}));
    assertThat(numbers("volume", two)).containsExactly(new double[] {2}, within(1e-14));
    assertThat(numbers("center", two)).containsExactly(new double[] {1.5, 0.5, 0.5}, within(1e-14));
  }

  /** The polyhedron of an inscribed sphere converges with the square of its edges. */
  @Test
  void sphereConvergesWithTheSquareOfTheEdges() throws IOException {
    double volume = 4 * Math.PI / 3;
    double[] coarse = errors(sphere(10), volume);
    double[] fine = errors(sphere(20), volume);
    for (int k = 0; k < coarse.length; k++) {
      assertThat(coarse[k] / fine[k]).isBetween(3.7, 4.3);
      assertThat(fine[k]).isLessThan(0.03 * volume);
    }
    assertThat(numbers("center", sphere(20)))
        .containsExactly(new double[] {3, 0, 0}, within(1e-13));
  }

  private double[] errors(List<double[][]> sphere, double volume) throws IOException {
    double[] moments = numbers("moments", sphere);
    return new double[] {
      volume - numbers("volume", sphere)[0],
      0.4 * volume - moments[0],
      0.4 * volume - moments[1],
      0.4 * volume - moments[2]
    };
  }

  @Test
  void binaryFileIsReadAsText() throws IOException {
    List<double[][]> block = box(0.5, 0.25, 2, new double[] {1, 2, 3});
    ByteBuffer bytes = ByteBuffer.allocate(84 + 50 * block.size()).order(ByteOrder.LITTLE_ENDIAN);
    bytes.put("solid, and yet binary".getBytes(StandardCharsets.US_ASCII)).position(80);
    bytes.putInt(block.size());
    for (double[][] triangle : block) {
      bytes.position(bytes.position() + 12);
      for (double[] corner : triangle) {
        for (double x : corner) {
          bytes.putFloat((float) x);
        }
      }
      bytes.putShort((short) 0);
    }
    Files.write(folder.resolve("part.stl"), bytes.array());
    byte[] binary = Files.readAllBytes(folder.resolve("part.stl"));
    String mesh = inlined("<MechML><mesh file='part.stl'/></MechML>");
    write("part.stl", text(block));
    String same = inlined("<MechML><mesh file='part.stl'/></MechML>");
    assertThat(mesh.replaceAll("sha256=\"[0-9a-f]*\"", ""))
        .isEqualTo(same.replaceAll("sha256=\"[0-9a-f]*\"", ""))
        .contains("center=\"1.25;2.125;4\"");
    assertThat(mesh).contains("sha256=\"" + Sha256.of(binary) + "\"");
  }

  @Test
  void openSurfaceIsRefusedWithAnEdge() {
    List<double[][]> open = box(1, 1, 1, new double[3]).subList(0, 11);
    assertThatThrownBy(() -> numbers("volume", open))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("part.stl")
        .hasMessageContaining("not closed")
        .hasMessageContaining("3 edges")
        .hasMessageContaining("(0;0;1)");
    List<double[][]> turned = new ArrayList<>(box(1, 1, 1, new double[3]));
    double[][] t = turned.get(4);
    turned.set(4, new double[][] {t[0], t[2], t[1]});
    assertThatThrownBy(() -> numbers("volume", turned)).hasMessageContaining("oriented alike");
  }

  @Test
  void fileThatIsNoSurfaceIsRefused() throws IOException {
    write("part.stl", "solid\nfacet\nvertex 0 0 0\n");
    assertThatThrownBy(() -> inlined("<MechML><mesh file='part.stl'/></MechML>"))
        .hasMessageContaining("cut off");
    write("part.stl", "solid\nvertex 0 zero 0\n");
    assertThatThrownBy(() -> inlined("<MechML><mesh file='part.stl'/></MechML>"))
        .hasMessageContaining("\"zero\"");
    write("part.stl", "OFF 8 6 12");
    assertThatThrownBy(() -> inlined("<MechML><mesh file='part.stl'/></MechML>"))
        .hasMessageContaining("no STL");
    write("part.stl", "solid\nendsolid\n");
    assertThatThrownBy(() -> inlined("<MechML><mesh file='part.stl'/></MechML>"))
        .hasMessageContaining("no volume");
  }

  @Test
  void includedFilesAreAppendedOnceWithThoseThatTheyInclude() throws IOException {
    write("a.part", "<subsystem><include file='sub/b.part'/><!-- ü ]]> --></subsystem>");
    write("sub/b.part", "<subsystem><table name='r' file='r.csv'/></subsystem>");
    write("r.csv", "1,2\n3,4\n");
    String model =
        "<MechML><!-- <include file='none'/> -->\n<include file='a.part'/>"
            + "<include file='a.part'/></MechML>\n";
    String text = inlined(model);
    assertThat(text)
        .startsWith("<MechML><!-- <include file='none'/> -->\n<include file='a.part'/>")
        .endsWith("]]></included>\n</MechML>\n")
        .containsOnlyOnce("<included file=\"a.part\" sha256=\"")
        .containsOnlyOnce("<included file=\"sub/b.part\" sha256=\"")
        .contains("<!-- ü ]]]]><![CDATA[> -->")
        .contains("x=\"1;3\" y=\"2;4\"");
    assertThat(inlined(text)).isEqualTo(text);
  }

  @Test
  void filesLieBesideTheModel() throws IOException {
    for (String name : List.of("../a.part", "/etc/passwd", "none.part")) {
      assertThatThrownBy(() -> inlined("<MechML><include file='" + name + "'/></MechML>"))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("an include");
    }
    Files.write(folder.resolve("a.part"), new byte[] {'<', (byte) 0xE4, '>'});
    assertThatThrownBy(() -> inlined("<MechML><include file='a.part'/></MechML>"))
        .hasMessageContaining("UTF-8");
    write("a.part", "\u0001");
    assertThatThrownBy(() -> inlined("<MechML><include file='a.part'/></MechML>"))
        .hasMessageContaining("control characters");
    write("a.part", "");
    assertThatThrownBy(
            () ->
                inlined(
                    "<?xml version='1.0' encoding='ISO-8859-1'?><MechML><include file='a.part'/>"
                        + "</MechML>"))
        .hasMessageContaining("UTF-8");
  }

  /** A folder from somewhere else may hold links to what its reader keeps private. */
  @Test
  void linksOutOfTheFolderAreRefusedAndThoseWithinAreNot() throws IOException {
    Path model = Files.createDirectories(folder.resolve("model"));
    Path secret = Files.createDirectories(folder.resolve("private"));
    Files.writeString(secret.resolve("t.csv"), "0,0\n1,1\n");
    Files.writeString(secret.resolve("p.part"), "<subsystem/>");
    Files.createSymbolicLink(model.resolve("out"), secret);
    for (String end : List.of("t.csv", "p.part")) {
      Files.createSymbolicLink(model.resolve(end), secret.resolve(end));
    }
    for (String element :
        List.of(
            "<table name='t' file='t.csv'/>",
            "<map name='m' file='t.csv'/>",
            "<mesh name='s' file='t.csv'/>",
            "<include file='p.part'/>",
            "<include file='out/p.part'/>",
            "<table name='t' file='out/t.csv'/>")) {
      byte[] text = ("<MechML>" + element + "</MechML>").getBytes(StandardCharsets.US_ASCII);
      assertThatThrownBy(() -> ModelFiles.inlined(text, model.resolve("m.xml")))
          .as(element)
          .isInstanceOf(IOException.class)
          .hasMessageContaining("is a link out of the model's folder");
    }
    Files.writeString(model.resolve("own.csv"), "0,0\n1,1\n");
    Files.createSymbolicLink(model.resolve("link.csv"), model.resolve("own.csv"));
    Path linked = Files.createSymbolicLink(folder.resolve("elsewhere"), model);
    byte[] text =
        "<MechML><table name='t' file='link.csv'/></MechML>".getBytes(StandardCharsets.US_ASCII);
    assertThat(
            new String(
                ModelFiles.inlined(text, linked.resolve("m.xml")), StandardCharsets.US_ASCII))
        .contains("x=\"0;1\"");
  }

  @Test
  void textWithoutFilesKeepsItsBytes() throws IOException {
    byte[] model = "<MechML>\u00fc</MechML>".getBytes(StandardCharsets.ISO_8859_1);
    assertThat(ModelFiles.inlined(model, folder.resolve("m.xml"))).isSameAs(model);
  }
}
