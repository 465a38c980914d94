package org.robonewbie.studio.service;

import java.io.IOException;
import java.util.List;
import java.util.function.UnaryOperator;

/** Service that handles requests from pages. Thread-safe. */
@FunctionalInterface
public interface PageService {

    /**
     * Handles a request.
     *
     * @param method HTTP method
     * @param path decoded path segments that follow the service's own path
     * @param parameters returns the value of a query parameter, empty if it is missing
     * @return JSON
     * @throws IOException if a file cannot be read or written, or no port is available
     * @throws IllegalArgumentException if the request is refused; the message gives the reason
     */
    String answer(String method, List<String> path, UnaryOperator<String> parameters) throws IOException;
}
