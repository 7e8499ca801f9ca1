package org.mechservice.client;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.pack.PackedClasses;

/** A model JAR and a runtime JAR made of this test's own classes. */
@SuppressWarnings("ArrayRecordComponent") // files in memory
record TestJars(byte[] model, byte[] runtime) {
  static final String MODEL_CLASS = SquareModel.class.getName();

  static TestJars make() {
    return make(Integer.toString(Model.API_VERSION));
  }

  static TestJars make(String apiVersion) {
    try {
      return new TestJars(jar(apiVersion, SquareModel.class), jar("1", SquareSolver.class));
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  /** A runtime JAR whose classes are packed in a form of another version. */
  static TestJars withRuntimePackedFor(String apiVersion) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JarOutputStream jar = new JarOutputStream(bytes, manifest(apiVersion))) {
      jar.putNextEntry(new JarEntry(PackedClasses.ENTRY));
      jar.write(new byte[] {1, 2, 3});
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
    return new TestJars(make().model(), bytes.toByteArray());
  }

  static Manifest manifest(String apiVersion) {
    Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
    manifest.getMainAttributes().put(new Attributes.Name("Mech-Api-Version"), apiVersion);
    return manifest;
  }

  private static byte[] jar(String apiVersion, Class<?> type) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JarOutputStream jar = new JarOutputStream(bytes, manifest(apiVersion))) {
      String file = type.getName().replace('.', '/') + ".class";
      jar.putNextEntry(new JarEntry(file));
      try (InputStream in = type.getClassLoader().getResourceAsStream(file)) {
        in.transferTo(jar);
      }
      if (Solver.class.isAssignableFrom(type)) {
        jar.putNextEntry(new JarEntry("META-INF/services/" + Solver.class.getName()));
        jar.write(type.getName().getBytes(StandardCharsets.UTF_8));
      }
    }
    return bytes.toByteArray();
  }
}
