package org.mechservice.cli.service;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.orb.tls.Role;
import org.mechservice.server.keys.KeyFolder;
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
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class KeysCommand implements Callable<Integer> {
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

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() {
    KeyFolder keys = KeyFolder.open(folder);
    if (Stream.of(hosts, clients, monitors, admins).allMatch(List::isEmpty)) {
      keys.localServer();
      clients = List.of("client");
      monitors = List.of("monitor");
      admins = List.of("admin");
    }
    hosts.forEach(names -> keys.server(List.of(names.split(",", -1))));
    clients.forEach(name -> keys.user(name, Role.CLIENT));
    monitors.forEach(name -> keys.user(name, Role.MONITOR));
    admins.forEach(name -> keys.user(name, Role.ADMIN));
    keys.made().forEach(spec.commandLine().getOut()::println);
    return ExitStatus.DONE;
  }
}
