package org.mechservice.admin.live;

import org.mechservice.idl.ServiceEvent;

/**
 * An event that a server has reported.
 *
 * @param number grows by one with each event of any server
 * @param server address of the server it came from
 * @param event the event
 */
public record ReceivedEvent(long number, String server, ServiceEvent event) {}
