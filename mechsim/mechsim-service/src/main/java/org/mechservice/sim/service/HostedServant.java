package org.mechservice.sim.service;

import org.mechservice.idl.IMechSimRemoteOperations;

/** A simulation of a session, going on or ended, as clients see it. */
interface HostedServant extends IMechSimRemoteOperations {
  /** Ends its cursors; there will be no new ones. */
  void closeCursors();
}
