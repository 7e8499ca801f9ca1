package org.mechservice.client.jar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.junit.jupiter.api.Test;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.solver.api.Model;

class FetchedJarTest {
  private static FetchedJar with(int entryBytes) throws IOException {
    Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
    manifest
        .getMainAttributes()
        .put(new Attributes.Name("Mech-Api-Version"), Integer.toString(Model.API_VERSION));
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JarOutputStream jar = new JarOutputStream(bytes, manifest)) {
      jar.putNextEntry(new JarEntry("zeros"));
      jar.write(new byte[entryBytes]);
    }
    assertThat(bytes.size()).isLessThan(100_000);
    return FetchedJar.read(bytes.toByteArray(), "the JAR");
  }

  @Test
  void entryThatInflatesWithoutBoundIsRefused() throws IOException {
    assertThat(with(1_000_000).entry("zeros"))
        .hasValueSatisfying(e -> assertThat(e).hasSize(1_000_000));
    FetchedJar bomb = with(50_000_000);
    assertThatThrownBy(() -> bomb.entry("zeros"))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageContaining("entry zeros of a fetched JAR has more than 33554432 bytes");
  }
}
