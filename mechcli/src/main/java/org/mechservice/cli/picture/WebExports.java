package org.mechservice.cli.picture;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Set;
import org.mechservice.cli.model.ModelToExport;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.MechSession;
import org.mechservice.client.SessionBuilds;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.report.ModelReport;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.page.PageFrame;
import org.mechservice.sim.fmu.FmiVersion;
import org.mechservice.sim.fmu.FmuArchive;
import org.mechservice.view.web.ModelExports;
import org.mechservice.view.web.ModelReader;

/** The exports of {@code mech web}: FMUs as {@code mech build} makes them, and quick reports. */
final class WebExports implements ModelExports {
  @Override
  public byte[] unit(String text, ModelReader.Choice choice) throws IOException {
    ReadOptions reading =
        new ReadOptions(choice.simulation(), choice.parameters(), Set.of())
            .withInputsAsParameters();
    try {
      byte[] content = text.getBytes(StandardCharsets.UTF_8);
      ModelToExport model = ModelToExport.read(content, reading);
      return FmuArchive.build(model.inC(Set.of()), FmiVersion.FMI_2).bytes();
    } catch (UsageException e) {
      throw new RefusedRequestException(400, String.valueOf(e.getMessage()));
    }
  }

  @Override
  public Path report(MechSession session, Path folder, Progress progress)
      throws IOException, InterruptedException {
    return new ModelReport(new SessionBuilds(session), folder, Effort.QUICK, progress::at)
        .write(Path.of("model.xml"));
  }

  @Override
  public String reportPolicy() {
    return PageFrame.policy();
  }
}
