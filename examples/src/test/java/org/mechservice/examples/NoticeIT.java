package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** NOTICE keeps up with the dependencies. */
class NoticeIT {
  @Test
  void namesEveryLibraryWithItsVersion() throws IOException {
    List<String> libraries =
        Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
            .map(path -> new File(path).getName())
            .filter(name -> name.endsWith(".jar"))
            // Our own modules are told by not having been fetched.
            .filter(name -> !Files.exists(WorkingTree.TOP.resolve(module(name))))
            .map(name -> name.replaceFirst("-([0-9][^-]*)\\.jar$", " $1"))
            .toList();

    assertThat(libraries).isNotEmpty();
    assertThat(Files.readString(WorkingTree.TOP.resolve("NOTICE"))).contains(libraries);
  }

  private static String module(String jar) {
    return jar.replaceFirst("(-[0-9].*)?\\.jar$", "");
  }
}
