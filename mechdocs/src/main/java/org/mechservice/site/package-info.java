/**
 * The user guide as static pages, which need neither a server nor a network: {@code
 * mechdocs/build-site}.
 *
 * <p>{@link org.mechservice.site.Site} reads the Markdown files of the repository, writes a page
 * for each at the same place, and copies the pictures and files that pages link. {@link
 * org.mechservice.site.GuidePage} makes HTML of one file: links to Markdown files become links to
 * their pages, headings get the anchors that they have on the web view of the repository. {@link
 * org.mechservice.site.Navigation} is the list of chapters on the left of each page, {@link
 * org.mechservice.site.SearchIndex} what the search field finds. {@link
 * org.mechservice.site.JavaReference} adds the Javadoc of the modules that programs call.
 */
@NullMarked
package org.mechservice.site;

import org.jspecify.annotations.NullMarked;
