package org.mechservice.solver.api;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * JARs of models in programs of their users. A class of its own, because a standalone JAR carries
 * {@link ModelSource} and no loader of classes.
 */
public final class ModelJarFile {
  private ModelJarFile() {}

  /**
   * Loads the model of a JAR, whose manifest names its class. The class sees those of this program,
   * and so does not need the solver that a standalone JAR carries.
   *
   * @param jar as {@code mech build} writes it
   * @throws IOException if the file cannot be read, or is no JAR of a model
   */
  public static ModelSource load(Path jar) throws IOException {
    String name;
    try (JarFile file = new JarFile(jar.toFile())) {
      Manifest manifest = file.getManifest();
      name = manifest == null ? null : manifest.getMainAttributes().getValue("Mech-Model");
    }
    if (name == null) {
      throw new IOException(
          MessageCode.STANDALONE_JAR_DAMAGED
              + " "
              + jar
              + " is no JAR of a model: its manifest has no Mech-Model; make one with mech build"
              + " MODEL.xml -o FILE.jar");
    }
    try {
      URLClassLoader loader =
          new URLClassLoader(new URL[] {jar.toUri().toURL()}, ModelSource.class.getClassLoader());
      return ModelSource.from(loader.loadClass(name).getDeclaredConstructor().newInstance());
    } catch (ReflectiveOperationException | LinkageError e) {
      throw new IOException(
          MessageCode.STANDALONE_JAR_DAMAGED + " the model in " + jar + " cannot be loaded: " + e,
          e);
    }
  }
}
