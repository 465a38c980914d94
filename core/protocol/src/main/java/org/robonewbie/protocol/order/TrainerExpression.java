package org.robonewbie.protocol.order;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/** One trainer command as a parsed expression: a name, followed by words and named lists of words in any order. */
final class TrainerExpression {

    private final NamedWords main;
    private final List<NamedWords> parts = new ArrayList<>();

    private TrainerExpression(NamedWords main) {
        this.main = main;
    }

    /** Parses the list whose name is the current atom. Returns empty if the list is incomplete. */
    static Optional<TrainerExpression> read(SexpReader in) {
        TrainerExpression expression = new TrainerExpression(NamedWords.of(in));
        while (in.next() != Token.CLOSE) {
            if (in.token() == Token.END) {
                return Optional.empty();
            }
            if (in.token() == Token.OPEN) {
                expression.readPart(in);
            } else {
                expression.main.add(in);
            }
        }
        return Optional.of(expression);
    }

    String name() {
        return main.name;
    }

    Optional<String> word() {
        return main.words.stream().findFirst();
    }

    Optional<Double> number() {
        return main.numbers.stream().findFirst();
    }

    /** Returns the words of a named list, or none if it is missing. */
    List<String> words(String name) {
        return find(name).map(part -> part.words).orElse(List.of());
    }

    /** Returns the words of a named list as numbers, or none if it is missing. */
    List<Double> numbers(String name) {
        return find(name).map(part -> part.numbers).orElse(List.of());
    }

    private Optional<NamedWords> find(String name) {
        return parts.stream().filter(part -> part.name.equals(name)).findFirst();
    }

    private void readPart(SexpReader in) {
        int outside = in.depth() - 1;
        if (in.next() == Token.ATOM) {
            NamedWords part = NamedWords.of(in);
            while (in.next() == Token.ATOM) {
                part.add(in);
            }
            parts.add(part);
        }
        in.skipTo(outside);
    }

    private record NamedWords(String name, List<String> words, List<Double> numbers) {

        static NamedWords of(SexpReader in) {
            return new NamedWords(in.text(), new ArrayList<>(), new ArrayList<>());
        }

        void add(SexpReader in) {
            words.add(in.text());
            numbers.add(in.number());
        }
    }
}
