package org.mechservice.sim.user;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import javax.tools.Diagnostic;
import javax.tools.JavaFileObject;
import org.mechservice.guard.WarmMain;
import org.mechservice.sim.compile.Compilation;
import org.mechservice.solver.api.UserForce;

/** Main class of a process that compiles sources for another process, one request at a time. */
final class CompilerMain {
  private static final List<String> OPTIONS =
      List.of(
          "--release",
          "17",
          "--limit-modules",
          "java.base",
          "-g",
          "-proc:none",
          "-implicit:none",
          "-Xlint:none");
  private static final Set<String> VISIBLE_PACKAGES = Set.of(UserForce.class.getPackageName());

  private static final long IDLE_MILLIS = 60_000;

  /** Longest text of a message, in characters; 3 bytes each fit into it. */
  private static final int MOST_TEXT = 10_000;

  private final DataOutputStream out;

  private CompilerMain(DataOutputStream out) {
    this.out = out;
  }

  /** Answers what comes on standard input, until it ends or nothing comes for a minute. */
  public static void main(String[] arguments) throws IOException {
    WarmMain.serve((first, in, out) -> new CompilerMain(out).answer(in), IDLE_MILLIS);
  }

  private void answer(DataInputStream in) throws IOException {
    int count = in.readInt();
    Map<String, String> sources = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      String name = in.readUTF();
      sources.put(name, new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8));
    }
    SortedMap<String, byte[]> others = new TreeMap<>();
    int files = in.readInt();
    for (int i = 0; i < files; i++) {
      String name = in.readUTF();
      others.put(name, in.readNBytes(in.readInt()));
    }
    compile(sources, others);
  }

  private void compile(Map<String, String> sources, SortedMap<String, byte[]> others)
      throws IOException {
    List<JavaFileObject> units = new ArrayList<>();
    sources.forEach(
        (name, text) ->
            units.add(Compilation.source(name.substring(0, name.lastIndexOf('.')), text)));
    try {
      Compilation done = Compilation.of(units, OPTIONS, VISIBLE_PACKAGES, others);
      List<Diagnostic<? extends JavaFileObject>> errors =
          done.diagnostics().stream()
              .filter(said -> said.getKind() == Diagnostic.Kind.ERROR)
              .toList();
      send(
          done.succeeded() || !errors.isEmpty() ? "" : "it says no reason",
          done.succeeded() ? done.classFiles() : new TreeMap<>(),
          done.succeeded() ? List.of() : errors);
    } catch (IllegalStateException | StackOverflowError e) {
      // Nested too deeply for the compiler's stack.
      send("it is nested too deeply", new TreeMap<>(), List.of());
    }
  }

  private void send(
      String givenUp,
      SortedMap<String, byte[]> classFiles,
      List<Diagnostic<? extends JavaFileObject>> errors)
      throws IOException {
    out.writeUTF(givenUp);
    out.writeInt(classFiles.size());
    for (Map.Entry<String, byte[]> file : classFiles.entrySet()) {
      out.writeUTF(file.getKey());
      out.writeInt(file.getValue().length);
      out.write(file.getValue());
    }
    List<Diagnostic<? extends JavaFileObject>> first =
        errors.subList(0, Math.min(errors.size(), SourceCompiler.MOST_ERRORS));
    out.writeInt(first.size());
    for (Diagnostic<? extends JavaFileObject> said : first) {
      JavaFileObject source = said.getSource();
      out.writeUTF(source == null ? "" : clipped(source.toUri().getPath().substring(1)));
      out.writeInt((int) Math.max(0, said.getLineNumber()));
      out.writeInt((int) Math.max(0, said.getColumnNumber()));
      out.writeInt((int) said.getPosition());
      out.writeInt((int) said.getEndPosition());
      out.writeUTF(clipped(String.valueOf(said.getCode())));
      out.writeUTF(clipped(said.getMessage(Locale.ROOT)));
    }
  }

  private static String clipped(String text) {
    return text.length() > MOST_TEXT ? text.substring(0, MOST_TEXT) + "..." : text;
  }
}
