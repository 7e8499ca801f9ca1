package org.mechservice.client.jar;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLConnection;
import java.net.URLStreamHandler;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.Simulation;
import org.mechservice.solver.text.Sha256;

/**
 * Loads classes from fetched JARs. A model runs with the solver of this process, or with one that
 * came with it; then both share only the artifact {@code solver-api} with the client, whose types
 * client and solver exchange.
 */
final class FetchedClasses extends ClassLoader {
  /** The packages of artifact {@code solver-api}; the ones below them belong to it too. */
  private static final List<String> SHARED_PACKAGES =
      List.of(
          Model.class.getPackageName(),
          MessageCode.class.getPackageName(),
          Sha256.class.getPackageName());

  private static final String PRODUCT = "org.mechservice.";
  private static final String SOLVER = PRODUCT + "solver.";

  private final List<FetchedJar> jars;
  private final Optional<ClassLoader> userClasses;

  /**
   * @param runtime JAR of the solver; empty: that of this process
   * @param userClasses loader of what users have written, in place of what the JARs have of it
   */
  FetchedClasses(
      FetchedJar model, Optional<FetchedJar> runtime, Optional<ClassLoader> userClasses) {
    super("fetched", runtime.isPresent() ? new SharedApi() : Simulation.class.getClassLoader());
    jars = Stream.concat(Stream.of(model), runtime.stream()).toList();
    this.userClasses = userClasses;
  }

  /** What the model has of its own comes from it, whatever this process calls so. */
  @Override
  protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
    if (name.startsWith(SOLVER) || jars.get(0).entry(file(name)).isEmpty()) {
      return super.loadClass(name, resolve);
    }
    synchronized (getClassLoadingLock(name)) {
      Class<?> loaded = findLoadedClass(name);
      return loaded == null ? findClass(name) : loaded;
    }
  }

  private static String file(String name) {
    return name.replace('.', '/') + ".class";
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    if (userClasses.isPresent() && !name.startsWith(PRODUCT)) {
      return userClasses.get().loadClass(name);
    }
    byte[] bytes = entry(file(name)).orElseThrow(() -> new ClassNotFoundException(name));
    return defineClass(name, bytes, 0, bytes.length);
  }

  @Override
  protected @Nullable URL findResource(String name) {
    return entry(name).map(bytes -> location(name, bytes)).orElse(null);
  }

  @Override
  protected Enumeration<URL> findResources(String name) {
    return Collections.enumeration(
        jars.stream()
            .flatMap(jar -> jar.entry(name).stream())
            .map(bytes -> location(name, bytes))
            .toList());
  }

  private Optional<byte[]> entry(String name) {
    return jars.stream().flatMap(jar -> jar.entry(name).stream()).findFirst();
  }

  private static URL location(String name, byte[] bytes) {
    try {
      return new URL("fetched", "", -1, "/" + name, new InMemory(bytes));
    } catch (MalformedURLException e) {
      throw new IllegalStateException("a URL with its own handler is never malformed", e);
    }
  }

  /** The platform, and the artifact shared with the client. */
  private static final class SharedApi extends ClassLoader {
    SharedApi() {
      super("shared-api", ClassLoader.getPlatformClassLoader());
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
      if (SHARED_PACKAGES.stream().noneMatch(shared -> name.startsWith(shared + "."))) {
        throw new ClassNotFoundException(name);
      }
      return Class.forName(name, false, Model.class.getClassLoader());
    }
  }

  /** Opens a resource that is held in memory. */
  private static final class InMemory extends URLStreamHandler {
    private final byte[] bytes;

    InMemory(byte[] bytes) {
      this.bytes = bytes;
    }

    @Override
    protected URLConnection openConnection(URL location) throws IOException {
      return new URLConnection(location) {
        @Override
        public void connect() {}

        @Override
        public InputStream getInputStream() {
          return new ByteArrayInputStream(bytes);
        }
      };
    }
  }
}
