/**
 * RoboNewbie in a web page: simulator, framework and examples as a WebAssembly module. Start with {@link
 * org.robonewbie.web.WebEdition}.
 *
 * <p>TeaVM compiles {@code field.wasm}, which contains the simulator, the framework and the examples, and {@code programs/robonewbie.wasm},
 * which adds the classes available to students' programs, the bytecode interpreter and the judge. {@code world-worker.js} runs one of them
 * in a worker, at most 15 ms in every 20 ms. {@link org.robonewbie.web.PacedWorld} is the clock, and {@link org.robonewbie.studio.PageFeed}
 * writes the messages to the page. {@code page/world-connection.js} replaces the studio's WebSocket, and {@code page/*-server.js} replace
 * the studio's server; all other scripts are the studio's. {@code compiler/javac.wasm} and {@code compiler/library.bin} are loaded on
 * demand. {@code service-worker.js} and {@code files.json} keep the page available offline.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web;
