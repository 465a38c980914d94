package org.robonewbie.site;

import java.util.List;

/** Thrown when the documentation contains broken links. */
public final class BrokenLinksException extends RuntimeException {

    private static final long serialVersionUID = 1;

    BrokenLinksException(List<String> broken) {
        super("Fix these broken links in the documentation:\n  " + String.join("\n  ", broken));
    }
}
