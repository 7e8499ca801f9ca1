/**
 * The service under load and faults: many clients, slow ones, hostile ones, processes killed, hosts
 * cut off. Servers and hosts are processes of their own, started as the command line starts them.
 */
@NullMarked
package org.mechservice.load;

import org.jspecify.annotations.NullMarked;
