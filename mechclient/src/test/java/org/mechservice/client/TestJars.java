package org.mechservice.client;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.Signature;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;

/** A model JAR and a runtime JAR made of this test's own classes. */
@SuppressWarnings("ArrayRecordComponent") // files in memory
record TestJars(byte[] model, byte[] runtime) {
  static final String MODEL_CLASS = SquareModel.class.getName();

  static TestJars make() {
    return make(Integer.toString(Model.API_VERSION));
  }

  static TestJars make(String apiVersion) {
    return make(apiVersion, "1");
  }

  private static TestJars make(String modelApi, String runtimeApi) {
    try {
      return new TestJars(jar(modelApi, SquareModel.class), jar(runtimeApi, SquareSolver.class));
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns a good model JAR, and a runtime JAR for another version of the solver API. */
  static TestJars withRuntimeFor(String apiVersion) {
    return new TestJars(make().model(), make(apiVersion, apiVersion).runtime());
  }

  /** Returns a model JAR whose class does what a class of a model need not. */
  static TestJars hostile() {
    return of(HostileModel.class);
  }

  /** Returns a JAR of one model class of these tests. */
  static TestJars of(Class<? extends Model> type) {
    try {
      return new TestJars(jar("1", type), make().runtime());
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns a model JAR of half a megabyte, whose classes have half a gigabyte. */
  static TestJars swelling() {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    byte[] zeros = new byte[1 << 24];
    try (JarOutputStream jar = new JarOutputStream(bytes, manifest("1"))) {
      for (int i = 0; i < 32; i++) {
        jar.putNextEntry(new JarEntry("org/mechservice/Zeros" + i + ".class"));
        jar.write(zeros);
      }
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
    return new TestJars(bytes.toByteArray(), make().runtime());
  }

  static KeyPair newKey() {
    try {
      KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
      generator.initialize(256);
      return generator.generateKeyPair();
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException(e);
    }
  }

  static byte[] signed(KeyPair key, byte[] bytes) {
    try {
      Signature signature = Signature.getInstance("SHA256withECDSA");
      signature.initSign(key.getPrivate());
      signature.update(bytes);
      return signature.sign();
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException(e);
    }
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
