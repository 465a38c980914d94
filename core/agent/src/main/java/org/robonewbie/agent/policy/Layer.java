package org.robonewbie.agent.policy;

import java.util.Arrays;

/** Layer of a neural network. Its parameters are a table, as in a policy's text. */
sealed interface Layer permits DenseLayer, LayerNormalization, GruLayer {

    /** Returns the number of inputs. */
    int inputs();

    /** Returns the number of outputs. */
    int outputs();

    /** Returns the activation function, which is applied to each output. */
    Activation activation();

    /** Returns the parameters, row by row. */
    double[] numbers();

    /** Returns the shape of the table of parameters. */
    Table table();

    /** Returns the words that follow the activation in a policy's text. */
    String kind();

    /** Returns how many numbers the layer remembers from one input to the next. */
    default int stateSize() {
        return 0;
    }

    /**
     * Evaluates the layer.
     *
     * @param input values of the inputs
     * @param state what the layer remembers, which is replaced
     * @param output receives the outputs
     */
    void apply(double[] input, double[] state, double[] output);

    /** Returns a row of the parameters. */
    default double[] row(int index) {
        int columns = table().columns();
        return Arrays.copyOfRange(numbers(), index * columns, (index + 1) * columns);
    }

    /** Checks the number of parameters. */
    static void requireSize(Table table, double... numbers) {
        if (numbers.length != table.size()) {
            throw new IllegalArgumentException("A layer of " + table.rows() + " rows of " + table.columns()
                    + " numbers needs " + table.size() + " numbers, not " + numbers.length + ".");
        }
    }

    /**
     * Shape of a table of parameters.
     *
     * @param rows number of rows
     * @param biases number of columns with biases, which precede the weights
     * @param weights number of columns with weights
     */
    record Table(int rows, int biases, int weights) {

        int columns() {
            return biases + weights;
        }

        int size() {
            return rows * columns();
        }
    }
}
