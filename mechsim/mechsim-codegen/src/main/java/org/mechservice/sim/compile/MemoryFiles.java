package org.mechservice.sim.compile;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardLocation;
import org.mechservice.guard.SolverClasses;

/**
 * The files of a compilation: the classes of the JDK, and on the class path some packages of the
 * solver and the given class files. Output stays in memory.
 */
final class MemoryFiles extends ForwardingJavaFileManager<JavaFileManager> {
  private final Set<String> visiblePackages;
  private final SortedMap<String, byte[]> others;
  private final SortedMap<String, ClassFile> written = new TreeMap<>();

  /**
   * @param visiblePackages packages of the solver that sources may name
   * @param others class files that they may name, by binary name; not modified
   */
  MemoryFiles(
      JavaFileManager standard, Set<String> visiblePackages, SortedMap<String, byte[]> others) {
    super(standard);
    this.visiblePackages = visiblePackages;
    this.others = others;
  }

  /** Returns a source file in memory. */
  static JavaFileObject source(String className, String source) {
    URI uri = uri(className, JavaFileObject.Kind.SOURCE);
    return new SimpleJavaFileObject(uri, JavaFileObject.Kind.SOURCE) {
      @Override
      public CharSequence getCharContent(boolean ignoreEncodingErrors) {
        return source;
      }
    };
  }

  private static URI uri(String className, JavaFileObject.Kind kind) {
    return URI.create("memory:///" + className.replace('.', '/') + kind.extension);
  }

  /** Returns the class files written so far, by binary name. */
  SortedMap<String, byte[]> written() {
    SortedMap<String, byte[]> bytes = new TreeMap<>();
    written.forEach((name, file) -> bytes.put(name, file.bytes()));
    return bytes;
  }

  @Override
  public Iterable<JavaFileObject> list(
      Location location, String packageName, Set<JavaFileObject.Kind> kinds, boolean recurse)
      throws IOException {
    if (location != StandardLocation.CLASS_PATH) {
      return location == StandardLocation.SOURCE_PATH
          ? List.of()
          : super.list(location, packageName, kinds, recurse);
    }
    List<JavaFileObject> found = new ArrayList<>();
    if (kinds.contains(JavaFileObject.Kind.CLASS)) {
      if (visiblePackages.contains(packageName)) {
        addSolverClasses(packageName, found);
      }
      others.forEach((name, bytes) -> add(packageName, name, bytes, found));
    }
    return found;
  }

  private static void addSolverClasses(String packageName, List<JavaFileObject> found) {
    String folder = packageName.replace('.', '/') + "/";
    SolverClasses.files()
        .subMap(folder, folder + Character.MAX_VALUE)
        .forEach(
            (path, bytes) -> {
              String name = path.substring(0, path.length() - ".class".length()).replace('/', '.');
              add(packageName, name, bytes, found);
            });
  }

  private static void add(
      String packageName, String className, byte[] bytes, List<JavaFileObject> found) {
    if (className.lastIndexOf('.') == packageName.length() && className.startsWith(packageName)) {
      found.add(new ClassFile(className, bytes));
    }
  }

  @Override
  public String inferBinaryName(Location location, JavaFileObject file) {
    return file instanceof ClassFile known
        ? known.className
        : super.inferBinaryName(location, file);
  }

  @Override
  public boolean isSameFile(FileObject a, FileObject b) {
    return a.toUri().equals(b.toUri());
  }

  @Override
  public boolean hasLocation(Location location) {
    return location == StandardLocation.CLASS_PATH
        || (location != StandardLocation.SOURCE_PATH && super.hasLocation(location));
  }

  @Override
  public JavaFileObject getJavaFileForOutput(
      Location location, String className, JavaFileObject.Kind kind, FileObject sibling) {
    ClassFile file = new ClassFile(className, new byte[0]);
    written.put(className, file);
    return file;
  }

  /** A class file in memory. */
  private static final class ClassFile extends SimpleJavaFileObject {
    private final String className;
    private final ByteArrayOutputStream content = new ByteArrayOutputStream();

    ClassFile(String className, byte[] bytes) {
      super(uri(className, Kind.CLASS), Kind.CLASS);
      this.className = className;
      content.writeBytes(bytes);
    }

    byte[] bytes() {
      return content.toByteArray();
    }

    @Override
    public InputStream openInputStream() {
      return new ByteArrayInputStream(content.toByteArray());
    }

    @Override
    public OutputStream openOutputStream() {
      return content;
    }
  }
}
