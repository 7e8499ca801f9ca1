package org.mechservice.cli.picture;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.mechservice.admin.web.Chromium;

/** One Chromium for the tests of a class; without it on this machine they are skipped. */
final class InstalledBrowser implements BeforeAllCallback, AfterAllCallback {
  private Optional<Chromium> started = Optional.empty();
  private Path profile = Path.of("");

  @Override
  public void beforeAll(ExtensionContext context) throws Exception {
    profile = Files.createTempDirectory("browser");
    started = Chromium.start(profile);
  }

  @Override
  public void afterAll(ExtensionContext context) throws Exception {
    if (started.isPresent()) {
      started.get().close();
    }
    List<Path> files;
    try (Stream<Path> walked = Files.walk(profile)) {
      files = walked.sorted(Comparator.reverseOrder()).toList();
    }
    for (Path file : files) {
      Files.deleteIfExists(file);
    }
  }

  /** Returns the browser; ends the test without a verdict if there is none. */
  Chromium get() {
    assumeTrue(started.isPresent(), "Chromium is not installed: no page is tried in it");
    return started.orElseThrow();
  }
}
