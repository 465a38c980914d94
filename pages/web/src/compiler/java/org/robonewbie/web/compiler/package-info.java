/**
 * {@code javac} in a web page: Java's compiler from the JDK of the build, with in-memory files. It is compiled to a
 * separate WebAssembly file under javac's licence (GPL 2 with Classpath Exception); the classes of this package are
 * RoboNewbie's. Start with {@link org.robonewbie.web.compiler.CompilerInPage}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.compiler;
