package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/**
 * The ways of bringing code into a command without the consent of its user, and what the command
 * says. Every piece of code in them writes the file {@code ESCAPED} when it is loaded or called.
 */
final class CodePaths {
  /** Each command that reads a model and may run it; m.xml is the model, s.xml a study of it. */
  static final List<String> COMMANDS =
      List.of(
          "check m.xml",
          "simulate m.xml",
          "simulate m.xml --mode local",
          "simulate m.xml --out r.glb",
          "build m.xml -o m.jar",
          "build m.xml -o m.jar --standalone",
          "build m.xml -o m.fmu",
          "view m.xml -o m.html",
          "report m.xml -o report --budget 5",
          "sweep m.xml --set k=1:2:2",
          "study s.xml -o s.csv",
          "optimise m.xml --minimise max(e) --by k=0:1",
          "identify m.xml --data data.csv --by k=0:1",
          "gradient m.xml --of last(e) --by k");

  private static final String CLASS = "fileName=\"Drag.class\"";

  /** A way of bringing code: what it writes into a folder with the files of {@link #files}. */
  @FunctionalInterface
  private interface Bringing {
    void into(Path folder) throws IOException;
  }

  /**
   * A way, and what is said of it.
   *
   * @param name of the way
   * @param said codes, one of which each command says
   * @param options that the command gets
   * @param variables of its environment, as a shell sets them
   */
  record Way(String name, List<String> said, String options, String variables) {
    @Override
    public String toString() {
      return name;
    }

    /** Writes its files. */
    void into(Path folder) throws IOException {
      files(folder);
      bringing(name).into(folder);
    }

    /**
     * Runs a command, which must refuse.
     *
     * @param mech how the shell starts the program
     */
    void refusedBy(String mech, String command, Terminal terminal, Path folder) {
      String words = command.replace("max(e)", "'max(e)'").replace("last(e)", "'last(e)'");
      Terminal.Ended ended = terminal.shell(variables + " " + mech + " " + words + " " + options);
      assertThat(ended.exitStatus()).as(ended.toString()).isBetween(1, 3);
      List<String> codes = new ArrayList<>(said);
      if (command.endsWith(".fmu")) {
        codes.add("S-170"); // there is no C of a class
      }
      assertThat(ended.stderr()).as(ended.toString()).containsAnyOf(codes.toArray(String[]::new));
      assertThat(ended.stderr()).doesNotContain("\tat ", "Exception");
      assertThat(folder.resolve("ESCAPED")).as(ended.toString()).doesNotExist();
    }
  }

  private CodePaths() {}

  static Stream<Way> ways() {
    return Stream.of(
        way("source beside the model", "S-169"),
        way("class beside the model", "S-169"),
        way("source beside a part that the model includes", "S-121"),
        way("source in the folder of its package", "S-169"),
        way("JAR beside the model", "S-121"),
        new Way("class on the class path", List.of("S-121"), "", "CLASSPATH=classes"),
        way("path out of the folder", "M-072"),
        way("path from the root", "M-072"),
        way("address", "M-072"),
        way("class of the program", "S-121"),
        way("class of Java", "S-121", "S-156"),
        way("service of the program", "S-169"),
        new Way("link out of the folder", List.of("S-121"), "--user-code linked", ""),
        new Way("folder of somebody else", List.of("S-121"), "--user-code empty", ""),
        way("source in the text of the model", "S-169", "S-121", "M-0"),
        way("text from another file", "M-003"));
  }

  /** Returns three commands for a way, other ones for the next. */
  static List<String> someCommands(Way way) {
    int first = ways().toList().indexOf(way);
    return IntStream.of(first, first + 5, first + 10)
        .mapToObj(i -> COMMANDS.get(i % COMMANDS.size()))
        .toList();
  }

  private static Way way(String name, String... said) {
    return new Way(name, List.of(said), "", "");
  }

  /** Writes a model that needs a class, and what commands need besides. */
  private static void files(Path folder) throws IOException {
    Files.writeString(folder.resolve("m.xml"), DraggedBob.MODEL);
    Files.writeString(
        folder.resolve("s.xml"),
        "<study model=\"m.xml\"><factor name=\"k\" values=\"1,2\"/><output name=\"e\""
            + " of=\"last(e)\"/></study>");
    Files.writeString(folder.resolve("data.csv"), "t,e\n0,0\n0.1,0.05\n0.2,0.1\n");
  }

  private static Bringing bringing(String name) {
    return switch (name) {
      case "source beside the model" -> folder -> source(folder, folder);
      case "class beside the model" -> folder -> compile(folder, folder);
      case "source beside a part that the model includes" -> CodePaths::part;
      case "source in the folder of its package" ->
          folder -> {
            needs(folder, "fileName=\"car.Drag.class\"");
            Path inPackage = source(folder, Files.createDirectory(folder.resolve("car")));
            String text = Files.readString(inPackage.resolve("Drag.java"));
            Files.writeString(inPackage.resolve("Drag.java"), "package car; " + text);
          };
      case "JAR beside the model" ->
          folder -> {
            Path classes = compile(folder, Files.createDirectory(folder.resolve("classes")));
            for (String jar : List.of("Drag.jar", "m.jar")) {
              new Terminal(classes).shell("jar cf ../" + jar + " Drag.class").orFail();
            }
            Files.delete(classes.resolve("Drag.class"));
          };
      case "class on the class path" ->
          folder -> compile(folder, Files.createDirectory(folder.resolve("classes")));
      case "path out of the folder" -> folder -> elsewhere(folder, "../");
      case "path from the root" -> folder -> elsewhere(folder, folder + "/");
      case "address" -> folder -> elsewhere(folder, folder.toUri().toString());
      case "class of the program" ->
          folder -> needs(folder, "fileName=\"org.mechservice.cli.Mech.class\"");
      case "class of Java" -> folder -> needs(folder, "fileName=\"java.lang.Thread.class\"");
      case "service of the program" ->
          folder -> {
            source(folder, folder);
            for (String type : List.of("UserForce", "Solver")) {
              Path services = Files.createDirectories(folder.resolve("META-INF/services"));
              Files.writeString(services.resolve("org.mechservice.solver.api." + type), "Drag");
            }
          };
      case "link out of the folder" ->
          folder -> {
            source(folder, Files.createDirectory(folder.resolve("elsewhere")));
            Files.createSymbolicLink(
                Files.createDirectory(folder.resolve("linked")).resolve("Drag.java"),
                folder.resolve("elsewhere/Drag.java"));
          };
      case "folder of somebody else" ->
          folder -> {
            source(folder, Files.createDirectory(folder.resolve("elsewhere")));
            Files.createDirectory(folder.resolve("empty"));
          };
      case "source in the text of the model" ->
          folder -> {
            source(folder, folder);
            String text = Files.readString(folder.resolve("Drag.java"));
            Files.delete(folder.resolve("Drag.java"));
            change(
                folder,
                "</MechML>",
                "<included file=\"Drag.java\"><![CDATA[" + text + "]]></included></MechML>");
          };
      case "text from another file" ->
          folder ->
              change(
                  folder,
                  "<MechML>",
                  "<!DOCTYPE MechML [<!ENTITY e SYSTEM \"file:///etc/hostname\">]><MechML>&e;");
      default -> throw new IllegalArgumentException(name);
    };
  }

  private static void change(Path folder, String before, String after) throws IOException {
    Path model = folder.resolve("m.xml");
    Files.writeString(model, Files.readString(model).replace(before, after));
  }

  private static void needs(Path folder, String file) throws IOException {
    change(folder, CLASS, file);
  }

  private static void elsewhere(Path folder, String prefix) throws IOException {
    source(folder, Files.createDirectory(folder.resolve("up")));
    needs(folder, "fileName=\"" + prefix + "up/Drag.class\"");
  }

  /** The force in a part, with its code beside it. */
  private static void part(Path folder) throws IOException {
    Path parts = source(folder, Files.createDirectory(folder.resolve("parts")));
    String force = "<force name=\"drag\" " + CLASS + "/>";
    Files.writeString(
        parts.resolve("p.part"),
        "<subsystem massUnits=\"kg\" lengthUnits=\"m\"><Forces>" + force + "</Forces></subsystem>");
    change(folder, force, "");
    change(folder, "<Bodies>", "<include file=\"parts/p.part\" prefix=\"x_\"/><Bodies>");
  }

  /**
   * Writes the source that escapes, into some folder.
   *
   * @param folder where {@code ESCAPED} appears
   */
  private static Path source(Path folder, Path into) throws IOException {
    String escape =
        "try { java.nio.file.Files.writeString(java.nio.file.Path.of(\""
            + folder.resolve("ESCAPED")
            + "\"), \"x\"); } catch (java.io.IOException e) { throw new IllegalStateException(e);"
            + " }";
    DraggedBob.writeSource(into, "static { " + escape + " }", escape, escape);
    return into;
  }

  private static Path compile(Path folder, Path into) throws IOException {
    Path source = source(folder, into).resolve("Drag.java");
    String classPath = System.getProperty("java.class.path");
    String[] words = {"--release", "17", "-cp", classPath, "-d", into.toString(), "" + source};
    assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, words)).isZero();
    Files.delete(source);
    return into;
  }
}
