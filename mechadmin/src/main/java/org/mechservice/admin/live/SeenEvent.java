package org.mechservice.admin.live;

import org.mechservice.idl.ServiceEvent;

/**
 * An event that was heard of.
 *
 * @param number grows by one per event heard of, of whichever server
 * @param server address of the server it came from
 * @param event the event
 */
public record SeenEvent(long number, String server, ServiceEvent event) {}
