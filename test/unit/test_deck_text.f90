module dg_test_deck_text
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_deck_number, only: read_integer, read_logical, read_real
   use dg_deck_schema, only: range_text, key_rule_type
   use dg_deck_text, only: group_type, parse_groups
   use dg_deck_token, only: token_type, tokenize, token_comma, token_end, token_equals, token_group, token_open_text, &
      token_stray, token_text, token_word
   use dg_error, only: add_fault, error_lines, error_list_type
   use dg_text, only: append_text, edit_distance, is_separator_free, lower_case, nearest_name, quoted, text_type, to_text
   use dg_unit_kind, only: unit_length, unit_diameter
   use dg_units, only: field_units, si_units
   implicit none
   private
   public :: deck_text_suite

contains

   function deck_text_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('deck_text')
      call suite%addTest(TestMethod('edit_distance', test_edit_distance))
      call suite%addTest(TestMethod('nearest_name', test_nearest_name))
      call suite%addTest(TestMethod('numbers_as_text', test_numbers_as_text))
      call suite%addTest(TestMethod('texts_for_messages', test_texts_for_messages))
      call suite%addTest(TestMethod('tokens', test_tokens))
      call suite%addTest(TestMethod('quotes', test_quotes))
      call suite%addTest(TestMethod('groups', test_groups))
      call suite%addTest(TestMethod('reals', test_reals))
      call suite%addTest(TestMethod('integers_and_logicals', test_integers_and_logicals))
      call suite%addTest(TestMethod('ranges', test_ranges))
      call suite%addTest(TestMethod('order_of_faults', test_order_of_faults))
   end function deck_text_suite

   !> Counted by hand; the swap of neighbours is one slip.
   subroutine test_edit_distance()
      call assertEqual(0, edit_distance('hole', 'hole'))
      call assertEqual(1, edit_distance('hoel', 'hole'), message='swap')
      call assertEqual(1, edit_distance('md_botom', 'md_bottom'), message='left out')
      call assertEqual(1, edit_distance('frictions', 'friction'), message='put in')
      call assertEqual(1, edit_distance('od', 'id'), message='changed')
      call assertEqual(3, edit_distance('kitten', 'sitting'))
      call assertEqual(4, edit_distance('', 'hole'))
      call assertEqual(2, edit_distance('ab', ''))
   end subroutine test_edit_distance

   subroutine test_nearest_name()
      character(11), parameter :: names(4) = [character(11) :: 'od', 'joint_od', 'survey_file', 'yield']
      call assertEqual('joint_od', nearest_name('jiont_od', names))
      call assertEqual('yield', nearest_name('YEILD', names), message='letter case aside')
      call assertEqual('survey_file', nearest_name('survey', names), message='a stem')
      call assertEqual('', nearest_name('xy', names), message='two slips make any two-letter name')
      call assertEqual('', nearest_name('something', names))
   end subroutine test_nearest_name

   subroutine test_numbers_as_text()
      call assertEqual('0', to_text(0.0_wp))
      call assertEqual('beyond all numbers', to_text(ieee_value(1.0_wp, ieee_positive_inf)))
      call assertEqual('215.9', to_text(215.9_wp))
      call assertEqual('-0.001', to_text(-1.0e-3_wp))
      call assertEqual('1e-9', to_text(1.0e-9_wp))
      call assertEqual('1000000', to_text(1.0e6_wp))
      call assertEqual('2.06e11', to_text(2.06e11_wp))
      call assertEqual('10', to_text(10.0_wp))
      call assertEqual('0.333', to_text(1.0_wp/3.0_wp, 3))
      call assertEqual('1', to_text(0.9999999_wp, 3), message='rounding carries')
      call assertEqual('-42', to_text(-42))
      ! 215.9 mm through metres is 215.90000000000001 or so
      call assertEqual('215.9', to_text(215.9_wp*1.0e-3_wp/1.0e-3_wp, 6))
   end subroutine test_numbers_as_text

   subroutine test_texts_for_messages()
      character(*), parameter :: u_umlaut = achar(195)//achar(188)
      call assertEqual('trip_out', lower_case('Trip_OUT'))
      call assertEqual("'a?b'", quoted('a'//achar(9)//'b'))
      call assertTrue(len(quoted(repeat('x', 500))) <= 50)
      call assertEqual("'"//repeat(u_umlaut, 22)//"....'", quoted(repeat(u_umlaut, 100)), message='cut between two letters')
      call assertEqual("'a??b'", quoted('a'//achar(194)//achar(155)//'b'), message='a command to a terminal')
      call assertTrue(is_separator_free('up_3190-a.b+'))
      call assertFalse(is_separator_free('a/b'))
      call assertFalse(is_separator_free('..'))
      call assertFalse(is_separator_free(''))
      call assertFalse(is_separator_free('a b'))
   end subroutine test_texts_for_messages

   subroutine test_tokens()
      type(token_type), allocatable :: tokens(:)
      integer :: i
      call cut("stray &hole md(2 : 3)=3*0.1,x ! comment / 'not'", '/ more &end', tokens)
      call assertEqual(10, size(tokens))
      call assertEqual([token_stray, token_group, token_word, token_equals, token_word, token_comma, token_word, token_end, &
                        token_stray, token_end], [(tokens(i)%kind, i=1, size(tokens))])
      call assertEqual([1, 1, 1, 1, 1, 1, 1, 2, 2, 2], [(tokens(i)%line, i=1, size(tokens))])
      call assertEqual('hole', tokens(2)%text)
      call assertEqual('md(2:3)', tokens(3)%text, message='blanks in a subscript do not count')
      call assertEqual('0.1', tokens(5)%text)
      call assertEqual(3, tokens(5)%repeat)
   end subroutine test_tokens

   subroutine test_quotes()
      type(token_type), allocatable :: tokens(:)
      call cut("&job a='it''s ! / &' b=2*""say ""x"" c='open", '/', tokens)
      call assertEqual("it's ! / &", tokens(4)%text)
      call assertEqual(token_text, tokens(4)%kind)
      call assertEqual(2, tokens(7)%repeat)
      call assertEqual('say ', tokens(7)%text)
      call assertEqual(token_open_text, tokens(size(tokens) - 1)%kind, message='open quote')
      call assertEqual(token_end, tokens(size(tokens))%kind, message='ends with its line')
   end subroutine test_quotes

   subroutine cut(first, second, tokens)
      character(*), intent(in) :: first, second
      type(token_type), allocatable, intent(out) :: tokens(:)
      type(text_type), allocatable :: lines(:)
      call append_text(lines, first)
      call append_text(lines, second)
      call tokenize(lines, tokens)
   end subroutine cut

   subroutine test_groups()
      type(token_type), allocatable :: tokens(:)
      type(group_type), allocatable :: groups(:)
      type(error_list_type) :: faults
      call cut('&Hole MD_top = 1 2, 3', 'od(2:3) = 2*''x'' / &fluid /', tokens)
      call parse_groups('deck', tokens, groups, faults)
      call assertEqual(0, faults%count)
      call assertEqual(2, size(groups))
      call assertEqual('hole', groups(1)%name)
      call assertEqual(2, size(groups(1)%entries))
      call assertEqual('md_top', groups(1)%entries(1)%key)
      call assertEqual(3, size(groups(1)%entries(1)%values))
      call assertEqual(2, groups(1)%entries(2)%line)
      call assertEqual(2, groups(1)%entries(2)%first)
      call assertEqual(3, groups(1)%entries(2)%last)
      call assertEqual(token_text, groups(1)%entries(2)%values(2)%kind)
      call assertEqual(0, size(groups(2)%entries))
   end subroutine test_groups

   subroutine test_reals()
      call check('1', 1.0_wp)
      call check('-1.5', -1.5_wp)
      call check('+.5', 0.5_wp)
      call check('5.', 5.0_wp)
      call check('1e3', 1000.0_wp)
      call check('1.5D-3', 1.5e-3_wp)
      call refuse('')
      call refuse('.')
      call refuse('-')
      call refuse('1e')
      call refuse('1e+')
      call refuse('1 2')
      call refuse('1,5')
      call refuse('1.2.3')
      call refuse('0x10')
      call refuse('inf')
      call refuse('nan')
      call refuse('1e400')
      call refuse('true')
   contains
      subroutine check(text, expected)
         character(*), intent(in) :: text
         real(wp), intent(in) :: expected
         real(wp) :: number
         logical :: legal
         call read_real(text, number, legal)
         call assertTrue(legal, message=text)
         call assertEqual(expected, number, message=text)   ! exact: both read by the same processor
      end subroutine check

      subroutine refuse(text)
         character(*), intent(in) :: text
         real(wp) :: number
         logical :: legal
         call read_real(text, number, legal)
         call assertFalse(legal, message='refused: '//text)
      end subroutine refuse
   end subroutine test_reals

   subroutine test_integers_and_logicals()
      integer :: number
      logical :: legal, flag
      call read_integer('-12', number, legal)
      call assertTrue(legal)
      call assertEqual(-12, number)
      call read_integer('12.0', number, legal)
      call assertFalse(legal)
      call read_integer('12345678901', number, legal)
      call assertFalse(legal, message='too large')
      call read_integer('+', number, legal)
      call assertFalse(legal)
      flag = .false.
      call read_logical('.TRUE.', flag, legal)
      call assertTrue(legal .and. flag)
      call read_logical('f', flag, legal)
      call assertTrue(legal .and. .not. flag)
      call read_logical('yes', flag, legal)
      call assertFalse(legal)
   end subroutine test_integers_and_logicals

   !> 1 m = 3.28084 ft, 25.4 mm = 1 in.
   subroutine test_ranges()
      call assertEqual('> 0 mm', range_text(key_rule_type(unit=unit_diameter, low=0.0_wp, open=.true.), si_units()))
      call assertEqual('>= 1 m', range_text(key_rule_type(unit=unit_length, low=1.0_wp), si_units()))
      call assertEqual('1 to 2', range_text(key_rule_type(low=1.0_wp, high=2.0_wp), si_units()))
      call assertEqual('3.2808 to 6.5617 ft', range_text(key_rule_type(unit=unit_length, low=1.0_wp, high=2.0_wp), &
                                                         field_units()))
      call assertEqual('> 0 and <= 1 in', range_text(key_rule_type(unit=unit_diameter, low=0.0_wp, high=25.4_wp, &
                                                                   open=.true.), field_units()))
      call assertEqual('', range_text(key_rule_type(), si_units()))
   end subroutine test_ranges

   subroutine test_order_of_faults()
      type(error_list_type) :: faults
      type(text_type), allocatable :: lines(:)
      integer :: i
      call add_fault(faults, 'deck', 9, 'nine')
      call add_fault(faults, 'survey', 1, 'one')
      call add_fault(faults, 'deck', 2, 'two')
      call add_fault(faults, 'deck', 9, 'nine again')
      call add_fault(faults, 'survey', 0, 'whole')
      do i = 1, 40
         call add_fault(faults, 'deck', 100 + i, 'many')
      end do
      allocate (lines, source=error_lines(faults))
      call assertEqual('deck:2: two', lines(1)%text)
      call assertEqual('deck:9: nine', lines(2)%text)
      call assertEqual('deck:9: nine again', lines(3)%text)
      call assertEqual('survey: whole', lines(44)%text)
      call assertEqual('survey:1: one', lines(45)%text)
   end subroutine test_order_of_faults
end module dg_test_deck_text
