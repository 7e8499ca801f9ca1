/**
 * What the pages served on the loopback interface have in common: the administration page and the
 * page for users.
 *
 * <p>A {@link org.mechservice.orb.http.Request} is one of a browser. It is answered with headers
 * under which nothing from elsewhere is loaded, nothing on the page can become a script, and no
 * other page can frame it. It says whether the server's own page caused it: a site that gives its
 * own name our address, or sends forms here, is found out.
 *
 * <p>Who may ask is known by an {@link org.mechservice.orb.http.AccessToken}, which travels in a
 * header that no other site can make a browser send. What cannot be answered is {@link
 * org.mechservice.orb.http.RefusedRequestException}. Pages are kept up to date by an {@link
 * org.mechservice.orb.http.EventStream}; their {@link org.mechservice.orb.http.PageFiles} are in
 * the program's own JAR.
 */
@NullMarked
package org.mechservice.orb.http;

import org.jspecify.annotations.NullMarked;
