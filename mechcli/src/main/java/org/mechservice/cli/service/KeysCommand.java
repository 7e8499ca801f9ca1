package org.mechservice.cli.service;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.orb.tls.Role;
import org.mechservice.server.keys.KeyFolder;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech keys}: certificates for a service over TLS. */
@Command(
    name = "keys",
    description = {
      "Makes a certificate authority and the identities of servers, hosts and users.",
      "Each identity is a folder: copy it to where it is used and name it with --tls. Keep the"
          + " folder ca to yourself. What is there already is kept, so more can be made later. If"
          + " none is named: server (for this machine alone), client, monitor and admin."
    },
    footer = "mech keys keys --host sim.example.org --client ann --admin root",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class KeysCommand implements Callable<Integer> {
  private static final int LONGEST_DAYS = 3650;

  @Parameters(paramLabel = "DIR", description = "Folder of all keys; made if need be.")
  private Path folder = Path.of("");

  @Option(
      names = "--host",
      paramLabel = "NAME[,NAME...]",
      description =
          "A machine that runs a server or host, with the names and addresses it is reached at; may"
              + " be given several times.")
  private List<String> hosts = List.of();

  @Option(
      names = "--client",
      paramLabel = "NAME",
      description = "A user; may be given several times.")
  private List<String> clients = List.of();

  @Option(
      names = "--monitor",
      paramLabel = "NAME",
      description =
          "Somebody who sees what administrators see and changes nothing; may be given several"
              + " times.")
  private List<String> monitors = List.of();

  @Option(
      names = "--admin",
      paramLabel = "NAME",
      description = "An administrator; may be given several times.")
  private List<String> admins = List.of();

  @Option(
      names = "--renew",
      paramLabel = "NAME",
      description =
          "Make a new key and certificate for this identity; processes that run with its folder"
              + " need no restart. May be given several times.")
  private List<String> renewed = List.of();

  @Option(
      names = "--revoke",
      paramLabel = "NAME",
      description =
          "Take the certificate of this identity back: writes revoked.crl, which belongs into the"
              + " --tls folder of each server and host. May be given several times.")
  private List<String> revoked = List.of();

  @Option(
      names = "--days",
      paramLabel = "N",
      description = "How long new certificates are valid, 1 to 3650 (default: 1095).")
  private Optional<Integer> days = Optional.empty();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() {
    KeyFolder keys = KeyFolder.open(folder);
    days.ifPresent(number -> keys.validFor(Duration.ofDays(usable(number))));
    if (Stream.of(hosts, clients, monitors, admins, renewed, revoked).allMatch(List::isEmpty)) {
      keys.localServer();
      clients = List.of("client");
      monitors = List.of("monitor");
      admins = List.of("admin");
    }
    hosts.forEach(names -> keys.server(List.of(names.split(",", -1))));
    clients.forEach(name -> keys.user(name, Role.CLIENT));
    monitors.forEach(name -> keys.user(name, Role.MONITOR));
    admins.forEach(name -> keys.user(name, Role.ADMIN));
    // Revocation comes first: a stolen identity is named in both options.
    revoked.forEach(name -> spec.commandLine().getOut().println(keys.revoke(name)));
    renewed.forEach(keys::renew);
    keys.made().forEach(spec.commandLine().getOut()::println);
    return ExitStatus.DONE;
  }

  private static int usable(int number) {
    if (number < 1 || number > LONGEST_DAYS) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --days is " + number + "; it must be 1 to 3650");
    }
    return number;
  }
}
