package org.mechservice.cli.picture;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import org.mechservice.cli.model.Examples;
import org.mechservice.cli.model.NewCommand;
import org.mechservice.cli.model.SceneReader;
import org.mechservice.cli.service.ListenOptions;
import org.mechservice.cli.service.ServingProcess;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.document.Document;
import org.mechservice.view.web.UserWeb;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech web}: models checked, run and watched in a browser of this machine. */
@Command(
    name = "web",
    description =
        "Serves a page on this machine to check, run and watch models, until it is stopped with"
            + " Ctrl-C.",
    footer = "mech web",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class WebCommand implements Callable<Integer> {
  private static final int DEFAULT_PORT = 15081;

  @Mixin private ServerOption server = new ServerOption();

  @Option(
      names = "--port",
      paramLabel = "P",
      description = "Port of the page; 0: any free one (default: ${DEFAULT-VALUE}).")
  private int port = DEFAULT_PORT;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws Exception {
    ListenOptions.usable(port);
    int atOnce = Math.max(2, Runtime.getRuntime().availableProcessors());
    try (ServiceConnection service = ServiceConnection.open(server, atOnce, UserCode.NONE);
        UserWeb web =
            new UserWeb(
                service.connection(),
                SceneReader::read,
                new WebExports(),
                examples(),
                Document.dtd(),
                port)) {
      spec.commandLine().getOut().println("open in a browser: " + web.url());
      spec.commandLine().getOut().flush();
      ServingProcess.untilEnded(web, new CountDownLatch(1)::await);
    }
    return ExitStatus.DONE;
  }

  /** Returns the models to begin with, by their names, in the order in which the page has them. */
  static Map<String, String> examples() throws IOException {
    Map<String, String> models = new LinkedHashMap<>();
    models.put("double pendulum", NewCommand.template().replace("@NAME@", "DoublePendulum"));
    try (Examples examples = Examples.open()) {
      models.put("bouncing ball", examples.text("benchmarks/bouncing_ball.xml"));
      models.put("slider-crank", examples.text("benchmarks/slider_crank_planar.xml"));
      models.put("four-bar, overconstrained", examples.text("extremes/fourbar_redundant.xml"));
      models.put("pendulum of five bars", examples.text("pendulum/pendulum.xml"));
      models.put("tumbling body", examples.text("benchmarks/dzhanibekov.xml"));
      models.put("flyball governor", examples.text("benchmarks/A05_flyball.xml"));
      models.put("squeezing mechanism", examples.text("benchmarks/A03_andrews.xml"));
      models.put("drive with PID control", examples.text("elements/pid.xml"));
      models.put("ball on the floor", examples.text("elements/contact.xml"));
      models.put("seat on a road", examples.text("optimise/seat.xml"));
    }
    return models;
  }
}
