package org.mechservice.sim.service.session;

import java.util.SortedMap;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.NotAvailable;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Decides whether a host runs the classes of users that a model has: the operator must allow it,
 * the machine must confine them, and the allow-list of bytecode must know all that they call.
 */
final class UserCodeAdmission {
  private static final Logger LOG = LoggerFactory.getLogger(UserCodeAdmission.class);

  /** Whether the allow-list of bytecode is asked; tests of the confinement alone switch it off. */
  static volatile boolean verifies = true;

  private UserCodeAdmission() {}

  /**
   * Refuses a model whose classes the host does not run.
   *
   * @param classFiles of users, by binary name; not modified
   * @throws NotAvailable S-120 if the operator does not allow it, S-168 without confinement
   * @throws InvalidModel if a class calls what the allow-list does not know
   */
  static void require(HostServices host, SortedMap<String, byte[]> classFiles)
      throws NotAvailable, InvalidModel {
    UserCodePolicy policy = host.userCode();
    if (policy == UserCodePolicy.REFUSED) {
      throw new NotAvailable(
          MessageCode.USER_CODE_NOT_ALLOWED.code(),
          "host "
              + host.hostName()
              + " runs no classes of users, and forces of this model are such classes; run it with"
              + " --mode local or without --server, or ask the operator to start the server with"
              + " --allow-user-code");
    } else if (!policy.runsBehind(Confinement.ofThisMachine())) {
      throw new NotAvailable(
          MessageCode.NO_CONFINEMENT.code(),
          Confinement.ofThisMachine().remedy("host " + host.hostName()));
    }
    if (!Confinement.ofThisMachine().stands()) {
      LOG.warn("classes of users run unconfined: {}", Confinement.ofThisMachine().text());
    }
    try {
      if (verifies) {
        UserClasses.requireHarmless(classFiles);
      }
    } catch (MechmlException e) {
      throw ContractErrors.model(e.diagnostics());
    }
  }
}
