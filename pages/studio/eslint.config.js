import js from '@eslint/js';
import globals from 'globals';

export default [
  { ignores: ['target/', '**/web/vendor/'] },
  js.configs.recommended,
  {
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      complexity: ['error', 15],
      'consistent-return': 'error',
      curly: 'error',
      'default-case-last': 'error',
      eqeqeq: 'error',
      'max-lines-per-function': ['error', 50],
      'no-else-return': 'error',
      'no-implicit-coercion': ['error', { boolean: false }],
      'no-shadow': 'error',
      'no-throw-literal': 'error',
      'no-unused-expressions': 'error',
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': 'error',
      'prefer-template': 'error',
    },
  },
  { files: ['src/main/**/*.js'], languageOptions: { globals: globals.browser } },
  {
    files: ['src/test/**/*.js', 'src/vendor/*.js', '*.js'],
    ignores: ['src/test/tools/fuzz-page.js'],
    languageOptions: { globals: globals.node },
  },
  { files: ['src/test/pages/**/*.js'], languageOptions: { globals: { ...globals.browser, studio: 'readonly' } } },
  { files: ['src/test/tools/fuzz-page.js'], languageOptions: { globals: globals.browser } },
];
