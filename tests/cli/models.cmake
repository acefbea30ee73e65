airlight_cli_help(models)
airlight_cli_test("models: the reference, the tables and published models are there" OUT "^reference,\"all orders\"," "^tables," "^preetham1999,.*,0,90,90,yes,\"\",Preetham1999$" COMMAND models)
airlight_cli_test("models: prague2021 without its authors' data set names what to give" EXIT 1 ERR "^prague2021: has no data of its own" "--data <file>"
  COMMAND probe earth-clear --zenith 30 --model prague2021 --wavelengths 550)
