/**
 * Java's own compiler in a page: {@code javac} out of the JDK that builds, with files that live in memory. Compiled to WebAssembly it
 * is a file of its own under javac's licence (GPL 2 with Classpath Exception); the classes of this package are RoboNewbie's. Read
 * {@link org.robonewbie.web.compiler.CompilerInPage} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.compiler;
