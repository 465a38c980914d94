/**
 * RoboNewbie in a web page: simulator, framework and examples as a WebAssembly module. Start with {@link
 * org.robonewbie.web.WebEdition}.
 *
 * <p>TeaVM compiles {@code field.wasm} with simulator, framework and examples, and {@code programs/robonewbie.wasm}, which adds
 * what students' programs may call, the bytecode interpreter and the judge. {@code world-worker.js} runs one of them in a
 * worker, at most 15 ms in every 20 ms. {@link org.robonewbie.web.PacedWorld} is the clock, and {@link
 * org.robonewbie.studio.PageFeed} writes what the page receives. {@code page/world-connection.js} replaces the studio's
 * WebSocket, and {@code page/*-server.js} answer what the studio requests from its server; all other scripts are the
 * studio's. {@code compiler/javac.wasm} and {@code compiler/library.bin} load on demand. {@code service-worker.js} and
 * {@code files.json} keep the page available without a network.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web;
