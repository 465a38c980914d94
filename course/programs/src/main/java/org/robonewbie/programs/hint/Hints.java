package org.robonewbie.programs.hint;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.robonewbie.nao.text.Spelling;

/**
 * Advice for compiler diagnostics: the missing import, the name from the framework that was probably meant, or general advice
 * on this kind of error.
 */
public final class Hints {

    /** Matches the location in a message, such as {@code location: class org.robonewbie.nao.motion.Posture}. */
    private static final Pattern OWNER =
            Pattern.compile("symbol: +method[^\\n]*\\n.*\\b(?:class|interface|of type) (?:\\w+\\.)*(\\w+)");

    /**
     * Matches the message for an unknown class that the compiler takes for a package, because two or more names follow
     * it.
     */
    private static final Pattern TAKEN_FOR_PACKAGE = Pattern.compile("package ([A-Z]\\w*) does not exist");

    /** Matches the message for an unknown class; before a dot, the compiler takes it for a variable. */
    private static final Pattern UNKNOWN_CLASS =
            Pattern.compile("symbol: +(?:class|variable [A-Z]\\w*[a-z])|" + TAKEN_FOR_PACKAGE.pattern());

    /** Matches the name in an import declaration: a package followed by a class or an asterisk. */
    private static final Pattern IMPORTED = Pattern.compile("((?:[a-z_]\\w*\\.)+)([A-Z]\\w*|\\*)");

    private static final Pattern UNKNOWN_PACKAGE = Pattern.compile("package ([a-z_]\\w*(?:\\.\\w+)*) does not exist");
    private static final Pattern IN_PACKAGE = Pattern.compile("location: +package ");

    private final FrameworkNames names;

    /**
     * Creates a source of advice.
     *
     * @param names candidates for misspelt names
     */
    public Hints(FrameworkNames names) {
        this.names = names;
    }

    /**
     * A compiler diagnostic.
     *
     * @param code the compiler's error code
     * @param place the underlined text
     * @param text the compiler's message in English
     */
    public record Remark(String code, String place, String text) {

        private boolean isUnknownName() {
            return code.contains("cant.resolve")
                    || code.contains("enum.label")
                    || TAKEN_FOR_PACKAGE.matcher(text).find();
        }

        /** Returns whether the diagnostic is about a qualified name, as in an import. */
        private boolean isAboutImport() {
            Matcher unknown = UNKNOWN_PACKAGE.matcher(text);
            boolean noPackage = unknown.find();
            return (IMPORTED.matcher(imported()).matches()
                            && (noPackage || IN_PACKAGE.matcher(text).find()))
                    || (noPackage && unknown.group(1).contains(".") && isWholePackage());
        }

        /**
         * Returns whether the diagnostic is about an import with an asterisk, for which the compiler does not underline the
         * package.
         */
        private boolean isWholePackage() {
            return !place.contains(".");
        }

        /** Returns the underlined text without surrounding whitespace. */
        private String imported() {
            return place.strip();
        }

        /** Returns whether the diagnostic is about an unknown variable, including one that the compiler took for a package. */
        private boolean isUnknownVariable() {
            return UNKNOWN_PACKAGE.matcher(text).find() && !isAboutImport();
        }

        /** Returns whether the diagnostic is about the simple name of a class; capitals alone are a constant. */
        private boolean isUnknownClass() {
            return UNKNOWN_CLASS.matcher(text).find();
        }

        private String lastName() {
            Matcher taken = TAKEN_FOR_PACKAGE.matcher(text);
            if (taken.find()) {
                return taken.group(1);
            }
            String name = place.substring(place.lastIndexOf('.') + 1).strip();
            return name.matches("\\w+") ? name : "";
        }
    }

    /**
     * Returns advice for a diagnostic.
     *
     * @param remark the diagnostic
     * @return one or two sentences; empty if there is no advice
     */
    public String of(Remark remark) {
        return meantImport(remark)
                .or(() -> missingImport(remark).map(line -> "Add at the top of the file: " + line))
                .or(() -> meant(remark))
                .or(() -> offers(remark))
                .orElseGet(() ->
                        BeginnersHints.of(remark.isUnknownVariable() ? "cant.resolve" : remark.code(), remark.place()));
    }

    /**
     * Returns the missing import line.
     *
     * @param remark the diagnostic
     * @return the line; empty if no import is missing
     */
    public Optional<String> missingImport(Remark remark) {
        return remark.isUnknownName() && !remark.isAboutImport() ? names.importOf(remark.lastName()) : Optional.empty();
    }

    /**
     * Removes follow-up errors caused by missing or misspelt imports: the compiler also reports every later use of such a
     * name, and every use of what a class inherits from it.
     *
     * @param all all diagnostics in the compiler's order
     * @param remark converts an element to a diagnostic
     * @param <R> the type of the elements
     * @return the diagnostics about imports, and one about each other unknown class; all diagnostics if none is about
     *     imports
     */
    public <R> List<R> withoutFollowUps(List<R> all, Function<? super R, Remark> remark) {
        List<Remark> imports =
                all.stream().map(remark).filter(Remark::isAboutImport).toList();
        if (imports.isEmpty()
                && all.stream().map(remark).map(this::missingImport).noneMatch(Optional::isPresent)) {
            return all;
        }
        boolean isAnyClassImported = imports.stream().anyMatch(Remark::isWholePackage);
        Set<String> named = imports.stream().map(Remark::lastName).collect(Collectors.toCollection(HashSet::new));
        return all.stream()
                .filter(each -> {
                    Remark said = remark.apply(each);
                    boolean isOther = missingImport(said).isPresent() || (!isAnyClassImported && said.isUnknownClass());
                    return said.isAboutImport() || (isOther && named.add(said.lastName()));
                })
                .toList();
    }

    /**
     * Suggests a correction for a misspelt import: the framework class with this name, or a package with a similar
     * name.
     */
    private Optional<String> meantImport(Remark remark) {
        if (!remark.isAboutImport()) {
            return Optional.empty();
        }
        String written = remark.imported();
        Matcher unknown = UNKNOWN_PACKAGE.matcher(remark.text());
        Optional<String> meant = Optional.ofNullable(names.types().get(remark.lastName()));
        if (meant.isEmpty() && unknown.find()) {
            String home = unknown.group(1);
            meant = Spelling.nearest(home, FrameworkNames.PACKAGES)
                    .map(near -> near + (remark.isWholePackage() ? ".*" : written.substring(home.length())));
        }
        return meant.map(name -> "Did you mean " + name + "?");
    }

    private Optional<String> meant(Remark remark) {
        String written = remark.lastName();
        if (written.isEmpty() || !remark.isUnknownName()) {
            return Optional.empty();
        }
        boolean constant = written.equals(written.toUpperCase(Locale.ROOT));
        boolean type = Character.isUpperCase(written.charAt(0)) && !constant;
        return Optional.of(Spelling.question(
                        written,
                        constant ? names.constants() : type ? names.types().keySet() : names.methodsOf(owner(remark))))
                .map(String::strip)
                .filter(question -> !question.isEmpty());
    }

    /** Lists the methods of the class, as advice for when none has a similar name. */
    private Optional<String> offers(Remark remark) {
        Optional<String> owner = remark.isUnknownName() ? owner(remark) : Optional.empty();
        return owner.map(type -> type + " has the methods " + String.join(", ", names.methodsOf(owner)) + ".");
    }

    /** Returns the framework class in which the compiler looked for a method. */
    private Optional<String> owner(Remark remark) {
        Matcher place = OWNER.matcher(remark.text());
        return place.find() ? Optional.of(place.group(1)).filter(names.types()::containsKey) : Optional.empty();
    }
}
