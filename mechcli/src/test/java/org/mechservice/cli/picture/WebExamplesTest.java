package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

@Tag("slow")
class WebExamplesTest {
  private static Stream<String> names() throws IOException {
    return WebCommand.examples().keySet().stream();
  }

  /** Each example needs no file beside it, so it runs in the page. */
  @ParameterizedTest
  @MethodSource("names")
  void exampleRunsByItself(String name, @TempDir Path folder) throws IOException {
    Path model = folder.resolve("model.xml");
    Files.writeString(model, WebCommand.examples().get(name));
    StringWriter err = new StringWriter();
    int status =
        Mech.run(
            new PrintWriter(new StringWriter()),
            new PrintWriter(err),
            "simulate",
            model.toString(),
            "--quiet",
            "--out",
            folder.resolve("r.csv").toString());
    assertThat(status).as(err.toString()).isEqualTo(ExitStatus.DONE);
  }
}
