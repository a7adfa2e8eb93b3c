import { defineConfig } from "vite";

// One script and one sheet with fixed names: the Rust side embeds them as text.
export default defineConfig({
  build: {
    target: "es2022",
    outDir: "dist",
    emptyOutDir: true,
    cssCodeSplit: false,
    lib: { entry: "src/main.ts", name: "bellcrankReport", formats: ["iife"], fileName: () => "report.js", cssFileName: "report" },
    rolldownOptions: {
      output: {
        postBanner: "/*! bellcrank report, MIT OR Apache-2.0. THIRD-PARTY: uPlot 1.6 (c) Leon Sorokin, MIT licence, see THIRD-PARTY.md */",
      },
    },
  },
});
